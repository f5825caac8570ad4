// SPDX-License-Identifier: MIT
#include "host_threads.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace ingot::platform {

namespace {

/// One row of tasks at a time. Each helper has a seat, a cache line through which it is offered its first task and tells that it is done: two
/// transfers between cores a row, where each takes the time of some hundred instructions. Further tasks are who takes them. An offer that a helper
/// has not taken when all else is done is taken back: so nobody waits for one that sleeps, or whose core is busy.
class Pool {
public:
    ~Pool() {
        ends_.store(true);
        wake();
        for (std::thread& thread : threads_) thread.join();
    }

    void run(int workers, int count, void (*call)(void*, int), void* task) {
        if (count < 1) return;
        const std::lock_guard<std::mutex> turn(turn_);
        while (static_cast<int>(threads_.size()) + 1 < workers) threads_.emplace_back([this, seat = &seats_[threads_.size()]] { serve(*seat); });
        const int offers = (count < workers ? count : workers) - 1;
        next_.store(offers + 1, std::memory_order_relaxed);
        for (int i = 0; i < offers; ++i) seats_[i].offer({call, task, i + 1, count});
        if (sleepers_.load() > 0) wake();
        do_tasks({call, task, 0, count});
        for (int i = 0; i < offers; ++i)
            if (seats_[i].take(idle)) call(task, i + 1);
        for (int i = 0; i < offers; ++i) seats_[i].wait();
    }

private:
    static constexpr int looks = 4000;  ///< for work, before a thread sleeps
    static constexpr int seats = 15;    ///< workers of a scene, but for the one that calls

    enum State { idle, offered, busy };
    struct Tasks {
        void (*call)(void*, int);
        void* task;
        int first, count;
    };
    struct alignas(64) Seat {
        std::atomic<State> state{idle};
        Tasks tasks{};

        void offer(const Tasks& of_row) {
            tasks = of_row;
            state.store(offered);  // in one order with sleepers_, for who is about to sleep
        }
        /// The offer becomes that of the helper, which is busy, or nobody's; false where there is none.
        bool take(State next) {
            State expected = offered;
            return state.load(std::memory_order_relaxed) == offered &&
                   state.compare_exchange_strong(expected, next, std::memory_order_acquire, std::memory_order_relaxed);
        }
        bool is_on() const { return state.load(std::memory_order_acquire) != idle; }
        /// Where it takes long, the core of the helper has gone to somebody else: perhaps it may have this one.
        void wait() const {
            for (int look = 0; look < looks && is_on(); ++look) pause();
            while (is_on()) std::this_thread::yield();
        }
    };

    static void pause() {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#else
        std::this_thread::yield();
#endif
    }

    void do_tasks(const Tasks& tasks) {
        tasks.call(tasks.task, tasks.first);
        while (next_.load(std::memory_order_relaxed) < tasks.count) {
            const int task_i = next_.fetch_add(1, std::memory_order_relaxed);
            if (task_i < tasks.count) tasks.call(tasks.task, task_i);
        }
    }

    void serve(Seat& seat) {
        while (!ends_.load(std::memory_order_relaxed)) {
            for (int look = 0; look < looks; ++look) {
                if (!seat.take(busy)) {
                    pause();
                    continue;
                }
                do_tasks(seat.tasks);
                seat.state.store(idle, std::memory_order_release);
                look = 0;
            }
            std::unique_lock<std::mutex> lock(sleep_);
            sleepers_.fetch_add(1);
            wake_.wait(lock, [&] { return ends_.load() || seat.state.load() == offered; });
            sleepers_.fetch_sub(1);
        }
    }

    void wake() {
        { const std::lock_guard<std::mutex> lock(sleep_); }  // who is about to sleep does so first, and hears it
        wake_.notify_all();
    }

    std::mutex turn_, sleep_;
    std::condition_variable wake_;
    std::vector<std::thread> threads_;
    std::atomic<int> sleepers_{0};
    std::atomic<bool> ends_{false};
    alignas(64) std::atomic<int> next_{0};  ///< of the row: the first task that nobody has
    Seat seats_[seats];
};

}  // namespace

void run_on_threads(int workers, int count, void (*call)(void*, int), void* task) {
    static Pool pool;
    pool.run(workers, count, call, task);
}

}  // namespace ingot::platform

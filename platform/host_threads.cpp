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

/// One row of tasks at a time. Which task is next stands in one word with how many there are and which row it is: who has taken a task by it knows
/// that the row is not over, so what is written before a row begins is not written while anybody reads it.
class Pool {
public:
    ~Pool() {
        ends_.store(true);
        wake();
        for (std::thread& thread : threads_) thread.join();
    }

    void run(int workers, int count, void (*call)(void*, int), void* task) {
        const std::lock_guard<std::mutex> turn(turn_);
        helpers_.store(workers - 1);
        while (static_cast<int>(threads_.size()) + 1 < workers)
            threads_.emplace_back([this, number = static_cast<int>(threads_.size())] { serve(number); });
        call_ = call;
        task_ = task;
        done_.store(0);
        row_ = (row_ + 1) & 0xffffffffu;
        row_and_task_.store(row_ << 32 | static_cast<uint64_t>(count) << 16);
        if (sleepers_.load() > 0) wake();
        while (work()) {}
        while (done_.load() < count) pause();
    }

private:
    static constexpr int looks = 4000;  ///< for work, before a thread sleeps

    static void pause() {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#else
        std::this_thread::yield();
#endif
    }
    static bool has_task(uint64_t word) { return (word & 0xffffu) < (word >> 16 & 0xffffu); }

    /// Takes a task and does it; false where none is left.
    bool work() {
        uint64_t word = row_and_task_.load();
        do {
            if (!has_task(word)) return false;
        } while (!row_and_task_.compare_exchange_weak(word, word + 1));
        call_(task_, static_cast<int>(word & 0xffffu));
        done_.fetch_add(1);
        return true;
    }

    void serve(int number) {
        while (!ends_.load()) {
            int look = 0;
            while (look < looks) look = number < helpers_.load() && work() ? 0 : (pause(), look + 1);
            std::unique_lock<std::mutex> lock(sleep_);
            sleepers_.fetch_add(1);
            wake_.wait(lock, [&] { return ends_.load() || (number < helpers_.load() && has_task(row_and_task_.load())); });
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
    std::atomic<uint64_t> row_and_task_{0};  ///< from above: row, how many tasks it has, how many of them are taken
    std::atomic<int> done_{0}, sleepers_{0}, helpers_{0};
    std::atomic<bool> ends_{false};
    uint64_t row_ = 0;
    void (*call_)(void*, int) = nullptr;
    void* task_ = nullptr;
};

}  // namespace

void run_on_threads(int workers, int count, void (*call)(void*, int), void* task) {
    static Pool pool;
    pool.run(workers, count, call, task);
}

}  // namespace ingot::platform

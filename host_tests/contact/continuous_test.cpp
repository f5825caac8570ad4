// SPDX-License-Identifier: MIT
// Bodies too fast for a step: nothing passes through anything, nothing is deflected that is not met.
#include <gtest/gtest.h>

#include "contact/play.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

template <int bodies>
struct FastRoom : Room<bodies> {
    static constexpr bool continuous = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};

void print_state(const char* what, const Play<FastRoom<2>>& s) {
  for (int i=0;i<2;++i) { auto r=s.r(i), v=s.v(i), w=s.omega(i); std::printf("%s %d r %g %g %g v %g %g %g w %g %g %g\n", what, i, r[0],r[1],r[2],v[0],v[1],v[2],w[0],w[1],w[2]); }
}

TEST(Now, plate) {
  for (double e : {0.,0.5,1.}) for (int phase=0; phase<4; ++phase) {
    Play<FastRoom<2>> s(bodies_from<2>([&](int i){return BulletAndPlate::body(i,static_cast<scalar>(phase*0.25),static_cast<scalar>(e));}),{});
    for (int k=0;k<6;++k) (void)s.step(BulletAndPlate::h);
    print_state(("plate e "+std::to_string(e)).c_str(), s);
  }
}
TEST(Now, head_on) {
  for (int rate : {30,60,240}) for (bool balls : {false,true}) for (int speed : {10,20,40,80}) {
    int passed=0; double worst_e=0;
    for (int phase=0; phase<40; ++phase) {
    Play<FastRoom<2>> s(bodies_from<2>([&](int i){return HeadOn::body(i,balls,static_cast<scalar>(speed),phase);}),{});
    double e0=s.energy();
    for (int k=0;k<6*rate/60+3;++k) (void)s.step(static_cast<scalar>(1.0/rate)), worst_e=std::max(worst_e,s.energy()/e0-1);
    passed += s.r(0)[0] > s.r(1)[0];
    }
    std::printf("head on %d Hz balls %d speed %d passed %d energy %g\n", rate, balls, speed, passed, worst_e);
  }
}
TEST(Now, bar) {
    Play<FastRoom<2>> s(bodies_from<2>([&](int i){return SpinningBar::body(i);}),{});
    double e0=s.energy(), worst=0, xmax=-9; int across=0;
    for (int k=0;k<60;++k) { (void)s.step(SpinningBar::h); worst=std::max(worst,s.energy()/e0-1); xmax=std::max(xmax,s.r(1)[0]);
       across += s.deepest_overlap()>0.01; if(k%4==0) print_state("bar",s);}
    std::printf("bar xmax %g across %d energy gain %g\n", xmax, across, worst);
}
TEST(Now, grazing) {
  for (bool oblique : {false,true}) for (int phase=0; phase<4; ++phase) {
    Play<FastRoom<2>> s(bodies_from<2>([&](int i){return Grazing::body(i,scalar(0.005),static_cast<scalar>(phase*0.25),oblique);}),{});
    for (int k=0;k<4;++k) (void)s.step(BulletAndPlate::h);
    print_state("graze", s);
  }
}
TEST(Now, between) {
    Play<FastRoom<3>> s(bodies_from<3>([&](int i){return BetweenPlates::body(i,1000);}),{});
    for (int k=0;k<60;++k) { (void)s.step(BulletAndPlate::h); if(k%10==0) std::printf("between x %g v %g\n", s.r(2)[0], s.v(2)[0]); }
}
TEST(Now, gap) {
    Play<FastRoom<3>> s(bodies_from<3>([&](int i){return ThroughGap::body(i,scalar(0.3));}),{});
    for (int k=0;k<4;++k) { (void)s.step(BulletAndPlate::h); std::printf("gap x %g %g v %g %g\n", s.r(2)[0],s.r(2)[1], s.v(2)[0],s.v(2)[1]); }
}
TEST(Now, stack) {
    Play<FastRoom<7>> s(bodies_from<7>([&](int i){return BulletIntoStack::body(i,scalar(0.3));}),OnEarth::gravity);
    double e0=s.energy();
    for (int k=0;k<60;++k) { (void)s.step(BulletAndPlate::h); if(k<20) std::printf("stack x %g v %g; cube x %g v %g e %g\n", s.r(6)[0], s.v(6)[0], s.r(3)[0], s.v(3)[0], s.energy()/e0); }
}
TEST(Now, walls) {
    Play<FastRoom<10>> s(bodies_of<BulletWalls>(),OnEarth::gravity);
    double e0=s.energy();
    for (int k=0;k<60;++k) { (void)s.step(BulletAndPlate::h); if(k<20){ std::printf("walls e %g:", s.energy()/e0); for(int i=2;i<10;++i) std::printf(" %.3g",s.r(i)[0]); std::printf("\n");} }
}

}  // namespace

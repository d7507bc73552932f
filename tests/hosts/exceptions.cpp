// SPDX-License-Identifier: GPL-3.0-or-later
// A host in C++ whose functions throw: the exception comes out of the call that the function was given to, and nothing is lost.
#include "check_host.h"
#include "mdrcontact.hpp"

#include <vector>

namespace {

struct Stopped : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void throw_from_function()
{
    mdr::Function bad([](double r) -> double {
        if (r > 0.5) throw Stopped("no height there");
        return r * r;
    });
    bool caught = false;
    try {
        auto never = mdr::make<mdr::Profile>(mdr_profile_function, bad.function(), bad.context(), 1.0);
    } catch (const Stopped &stopped) {
        caught = std::string(stopped.what()) == "no height there";
    }
    CHECK(caught);
    mdr::Function good([](double r) { return r * r; });
    auto bowl = mdr::make<mdr::Profile>(mdr_profile_function, good.function(), good.context(), 1.0);
    double f = 0.0;
    const double r = 0.5;
    mdr::check(mdr_profile_values(bowl, MDR_HEIGHT, 1, &r, &f));
    CHECK(f > 0.2499 && f < 0.2501);
}

// The program ignores the status of one call: the exception of the next one is that of its own function.
void ignore_a_status()
{
    mdr::Function first([](double) -> double { throw Stopped("first"); });
    mdr::Function second([](double) -> double { throw Stopped("second"); });
    mdr_profile *never = nullptr;
    std::string caught;

    CHECK(mdr_profile_function(first.function(), first.context(), 1.0, &never) == MDR_ECALLBACK);
    try {
        mdr::check(mdr_profile_function(second.function(), second.context(), 1.0, &never));
    } catch (const Stopped &stopped) {
        caught = stopped.what();
    }
    CHECK(caught == "second");
}

void throw_from_cancel(int threads)
{
    const mdr_layer film = mdr_isotropic(10.0, 0.2, 0.5), below = mdr_isotropic(1.0, 0.3, 0.0);
    auto body = mdr::make<mdr::Body>(mdr_body_layered, 1, &film, &below, nullptr);
    auto medium = mdr::make<mdr::Medium>(mdr_medium_new, body, nullptr);
    // long enough for the function to be asked on any machine; what is not cancelled takes a part of it
    std::vector<double> a(400000), E(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = 0.01 + 5e-6 * static_cast<double>(i);
    const int n = static_cast<int>(a.size());
    bool caught = false;

    mdr::check(mdr_set_threads(threads));
    {
        mdr::Cancel cancel([]() -> bool { throw Stopped("window closed"); });
        try {
            mdr::check(mdr_medium_values(medium, MDR_MODULUS, n, a.data(), E.data()));
        } catch (const Stopped &) {
            caught = true;
        }
    }
    CHECK(caught);
    mdr::check(mdr_medium_values(medium, MDR_MODULUS, 100, a.data(), E.data()));
    CHECK(E[0] > 1.0);
    int status = MDR_SUCCESS;
    {
        mdr::Cancel cancel([] { return true; });
        try {
            mdr::check(mdr_medium_values(medium, MDR_MODULUS, n, a.data(), E.data()));
        } catch (const mdr::Error &error) {
            status = error.status();
        }
    }
    CHECK(status == MDR_ECANCELLED);
}

} // namespace

int main()
{
    throw_from_function();
    ignore_a_status();
    throw_from_cancel(1);
    throw_from_cancel(2);
    return host_report("exceptions");
}

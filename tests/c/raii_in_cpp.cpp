// SPDX-License-Identifier: GPL-3.0-or-later
// mdrcontact.hpp: Hertz's force, owners that move, refusals with their words. Memory is looked at by valgrind.
#include "mdrcontact.hpp"

#include <cmath>
#include <cstdio>
#include <thread>
#include <type_traits>

static int failures = 0;

static void expect(bool right, const char *what)
{
    if (right) return;
    std::printf("%s is wrong\n", what);
    ++failures;
}

static mdr::LawHandle some_law()
{
    const auto ball = mdr::make<mdr::Profile>(mdr_profile_paraboloid, 1e-5);
    const mdr_layer glass = mdr_isotropic(72e9, 0.17, 0.0);
    const auto body = mdr::make<mdr::Body>(mdr_body_layered, 0, nullptr, &glass, nullptr);
    const auto medium = mdr::make<mdr::Medium>(mdr_medium_new, body, nullptr);
    const auto contact = mdr::make<mdr::Contact>(mdr_contact_new, ball, medium, nullptr);
    return mdr::make<mdr::LawHandle>(mdr_law_new, contact, 2e-7, nullptr);
}

template <class Call> static mdr::Error refusal(Call call)
{
    try {
        call();
    } catch (const mdr::Error &error) {
        return error;
    }
    return mdr::Error(MDR_SUCCESS, "no refusal");
}

int main()
{
    static_assert(!std::is_copy_constructible_v<mdr::Medium> && std::is_nothrow_move_constructible_v<mdr::Medium>);
    const mdr::Law law(some_law());
    const double hertz = 4.0 / 3.0 * 72e9 / (1.0 - 0.17 * 0.17) * std::sqrt(1e-5) * std::pow(1e-7, 1.5);
    expect(std::fabs(law.force(1e-7) / hertz - 1.0) < 1e-9, "Hertz's force");
    expect(law.at_depth(1e-7).force == law.force(1e-7) && law.force(-1.0) == 0.0, "the state");
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    mdr::check(mdr_law_about(law, &facts));
    expect(facts.buffer_size > 0, "a law as an argument");

    mdr::LawHandle one = some_law(), other = std::move(one);
    expect(one == nullptr && other != nullptr, "a move");
    one = std::move(other);
    mdr::check(mdr_law_load("no such file", other.receive()) == MDR_EFILE ? MDR_SUCCESS : MDR_EINVALID);
    expect(other == nullptr, "a failed receive");

    const mdr::Error negative = refusal([] { mdr::make<mdr::Profile>(mdr_profile_paraboloid, -1.0); });
    expect(negative.status() == MDR_EINVALID && negative.argument() == "radius", "the argument of a refusal");
    const mdr::Error deep = refusal([&] { law.force(1.0); });
    expect(deep.status() == MDR_EDOMAIN && std::string(deep.what()).find("compiled up to") != std::string::npos,
           "the words of a depth");
    std::thread([&] { // the words are of the thread that failed
        expect(refusal([&] { law.at_depth(NAN); }).status() == MDR_EINVALID, "a refusal of another thread");
    }).join();
    std::printf("raii: %d failed\n", failures);
    return failures != 0;
}

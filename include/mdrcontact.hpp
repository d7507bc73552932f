// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file mdrcontact.hpp
 * The library in C++17: objects that free themselves, and failures as exceptions. Header only; mdrcontact.h
 * describes what each function computes.
 *
 *     auto ball = mdr::make<mdr::Profile>(mdr_profile_paraboloid, 1e-5);
 *     auto glass = mdr_isotropic(72e9, 0.17, 0);
 *     auto plate = mdr::make<mdr::Body>(mdr_body_layered, 0, nullptr, &glass, nullptr);
 *     auto medium = mdr::make<mdr::Medium>(mdr_medium_new, plate, nullptr);
 *     auto contact = mdr::make<mdr::Contact>(mdr_contact_new, ball, medium, nullptr);
 *     mdr::check(mdr_contact_states(contact, MDR_DEPTH, MDR_ON_UNLOADING, n, d, states));
 *     mdr::Law law(mdr::make<mdr::LawHandle>(mdr_law_new, contact, 2e-7, nullptr));
 *     double F = law.force(1e-7);
 */
#ifndef MDRCONTACT_HPP
#define MDRCONTACT_HPP

#include "mdrcontact_law.h"

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace mdr {

/** A failure, with the text of the library. */
class Error : public std::runtime_error {
public:
    /** @param status   one of enum mdr_status
     *  @param words    text of the failure
     *  @param argument the argument at fault; empty: none
     *  @param entry    of an array, from 1; 0: none */
    Error(int status, const std::string &words, std::string argument = "", int entry = 0)
        : std::runtime_error(words), status_(status), argument_(std::move(argument)), entry_(entry)
    {
    }
    int status() const noexcept { return status_; }
    const std::string &argument() const noexcept { return argument_; }
    int entry() const noexcept { return entry_; }

private:
    int status_;
    std::string argument_;
    int entry_;
};

namespace detail {
/* What a function of the program has thrown while the library called it. */
inline std::exception_ptr &thrown()
{
    thread_local std::exception_ptr kept;
    return kept;
}
} // namespace detail

/** Call a function for the library, which no exception may leave: it is kept for check(). For functions of types other than those
 *  of Function and Cancel.
 *  @param call  returns the status
 *  @return that status, or 1 after an exception */
template <class Call> int guarded(Call &&call) noexcept
{
    try {
        return call();
    } catch (...) {
        detail::thrown() = std::current_exception();
        return 1;
    }
}

/** Throw unless a status is MDR_SUCCESS: the exception of a function that the library called, or Error. Call it in the thread that
 *  received the status, to which the text belongs. */
inline void check(int status)
{
    if (status == MDR_SUCCESS) return;
    if (status == MDR_ECALLBACK || status == MDR_ECANCELLED) {
        if (auto kept = std::exchange(detail::thrown(), nullptr)) std::rethrow_exception(kept);
    }
    mdr_failure failure = MDR_SIZED(mdr_failure);
    mdr_last_failure(&failure);
    throw Error(status, mdr_last_error(), failure.argument, failure.entry);
}

/** An object of the library, which it frees. It can be moved but not copied, and converts to the handle that it owns. Objects of
 *  extensions are Handle<mdr_wear> and so on. */
template <class Object> class Handle {
public:
    Handle() = default;
    explicit Handle(Object *object) noexcept : object_(object) {}
    Handle(Handle &&other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Handle &operator=(Handle &&other) noexcept
    {
        std::swap(object_, other.object_);
        return *this;
    }
    Handle(const Handle &) = delete;
    Handle &operator=(const Handle &) = delete;
    ~Handle() { mdr_free(object_); }
    operator Object *() const noexcept { return object_; }
    /** The address for a function that creates an object. The previous object is freed. */
    Object **receive()
    {
        check(mdr_free(object_));
        object_ = nullptr;
        return &object_;
    }

private:
    Object *object_ = nullptr;
};

using Profile = Handle<mdr_profile>;
using Material = Handle<mdr_material>;
using Body = Handle<mdr_body>;
using Response = Handle<mdr_response>;
using Medium = Handle<mdr_medium>;
using Contact = Handle<mdr_contact>;
using Loop = Handle<mdr_loop>;
using Friction = Handle<mdr_friction>;
using Shear = Handle<mdr_shear>;
using FrictionHistory = Handle<mdr_friction_history>;
using LawHandle = Handle<mdr_law>;

/** Create an object with a function of the library whose last argument receives it. Throws Error. */
template <class Made, class Function, class... Arguments> Made make(Function function, Arguments &&...arguments)
{
    Made made;
    check(function(std::forward<Arguments>(arguments)..., made.receive()));
    return made;
}

/** A function y = f(x) of the program for the library, which may throw: check() throws the exception again. Use:
 *
 *     mdr::Function bowl([](double r) { return r * r; });
 *     auto tip = mdr::make<mdr::Profile>(mdr_profile_function, bowl.function(), bowl.context(), 1e-5);
 */
class Function {
public:
    explicit Function(std::function<double(double)> f) : f_(std::move(f)) {}
    Function(const Function &) = delete;
    Function &operator=(const Function &) = delete;
    mdr_function function() const noexcept { return call; }
    void *context() noexcept { return this; }

private:
    static int call(double x, double *y, void *context) noexcept
    {
        return guarded([&] {
            *y = static_cast<Function *>(context)->f_(x);
            return 0;
        });
    }
    std::function<double(double)> f_;
};

/** A function that cancels long calls of this thread as long as this object lives, see mdr_set_cancel(). It returns true to cancel,
 *  and may throw: the call is cancelled, and check() throws the exception again. One object at a time for each thread. */
class Cancel {
public:
    explicit Cancel(std::function<bool()> stop) : stop_(std::move(stop))
    {
        detail::thrown() = nullptr;
        mdr_set_cancel(call, this);
    }
    Cancel(const Cancel &) = delete;
    Cancel &operator=(const Cancel &) = delete;
    ~Cancel() { mdr_set_cancel(nullptr, nullptr); }

private:
    static int call(void *context) noexcept
    {
        return guarded([&] { return static_cast<Cancel *>(context)->stop_() ? 1 : 0; });
    }
    std::function<bool()> stop_;
};

/** A compiled law on one branch, with the inline functions of mdrcontact_law.h. Any number of threads may share it. */
class Law {
public:
    /** @param law     the law, owned from now on
     *  @param branch  one of enum mdr_branch */
    explicit Law(LawHandle law, int branch = MDR_ON_UNLOADING) : law_(std::move(law))
    {
        check(mdr_law_view_of(law_, branch, &view_));
    }
    /** F at a depth. Throws Error if the law does not cover the depth. */
    double force(double d) const
    {
        double F;
        if (mdr_law_view_force(&view_, d, &F) != MDR_SUCCESS) refuse(d);
        return F;
    }
    /** The state at a depth. Throws Error if the law does not cover the depth. */
    mdr_law_point at_depth(double d) const
    {
        mdr_law_point point;
        if (mdr_law_view_state(&view_, d, &point) != MDR_SUCCESS) refuse(d);
        return point;
    }
    const mdr_law_view &view() const noexcept { return view_; }
    operator const mdr_law *() const noexcept { return law_; }

private:
    [[noreturn]] void refuse(double d) const
    {
        check(mdr_law_force(law_, view_.branch, d, nullptr, nullptr));
        throw Error(MDR_EINVALID, "the view does not belong to the law");
    }
    LawHandle law_;
    mdr_law_view view_;
};

} // namespace mdr

#endif

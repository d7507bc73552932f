% SPDX-License-Identifier: GPL-3.0-or-later
% Octave: the law of a ball on a coated half-space, and its states. octave-cli law.m, after mkoctfile --mex of both functions.
%
% Checks: slope and stiffness agree; the slope is that of F by differences; equal materials give Hertz's force; a law that was saved by
% Octave and read again is the same; refusals are errors with words.
1;

function words = words_of (action)
  words = "";
  try
    action ();
  catch problem
    words = problem.message;
  end_try_catch
endfunction

coated = law_of_ball (1e-5, [72e9 0.17], 1e-6, [160e9 0.25], 1e-7);
depth = linspace (5e-9, 95e-9, 50);
step = 1e-12;
[force, slope, radius, stiffness] = law_states (coated, depth);
by_differences = (law_states (coated, depth + step) - law_states (coated, depth - step)) / (2 * step);
hertz = 4 / 3 * 72e9 / (1 - 0.17 ^ 2) * sqrt (1e-5) * depth .^ 1.5;
equal = law_states (law_of_ball (1e-5, [72e9 0.17], 1e-6, [72e9 0.17], 1e-7), depth);
largest = max (abs ([slope ./ by_differences, slope ./ stiffness, equal ./ hertz] - 1));
power = polyfit (log (depth), log (force), 1)(1);

file = tempname ();
save ("-binary", file, "coated");
kept = load (file);
delete (file);

printf ("F = %.4f mN at %.0f nm, F ~ d^%.2f, largest relative error %.1e\n", 1e3 * force(end), 1e9 * depth(end), power, largest);
assert (largest < 1e-6);
assert (power > 1.4 && power < 1.7);
assert (isequal (law_states (kept.coated, depth), force));
assert (! isempty (strfind (words_of (@() law_states (coated, 1)), "beyond the law")));
assert (! isempty (strfind (words_of (@() law_of_ball (-1, [72e9 0.17], 1e-6, [72e9 0.17], 1e-7)), "greater than 0")));
assert (! isempty (strfind (words_of (@() law_states (1:100, depth)), "no law")));

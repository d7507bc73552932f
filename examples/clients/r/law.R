# SPDX-License-Identifier: GPL-3.0-or-later
# R: the law of a ball on a coated half-space, its states as a data frame. Rscript law.R, after R CMD SHLIB law.c.
#
# Checks: slope and stiffness agree; the slope is that of F by differences; equal materials give Hertz's force; a refusal is an error
# with the library's words.
dyn.load(paste0("law", .Platform$dynlib.ext))
law_of_ball <- function(film, base) .Call("law_of_ball", c(1e-5, film, 1e-6, base, 1e-7))
states <- function(depth, law = coated) {
  found <- .Call("law_states", law, as.double(depth))
  data.frame(depth = depth, force = found[, 1], slope = found[, 2], radius = found[, 3], stiffness = found[, 4])
}

coated <- law_of_ball(c(72e9, 0.17), c(160e9, 0.25))
depth <- seq(5e-9, 95e-9, length.out = 50)
step <- 1e-12
by_differences <- (states(depth + step)$force - states(depth - step)$force) / (2 * step)
curve <- states(depth)
hertz <- 4 / 3 * 72e9 / (1 - 0.17^2) * sqrt(1e-5) * depth^1.5
equal <- states(depth, law_of_ball(c(72e9, 0.17), c(72e9, 0.17)))
largest <- max(abs(curve$slope / by_differences - 1), abs(curve$slope / curve$stiffness - 1), abs(equal$force / hertz - 1))
refused <- tryCatch(states(1), error = conditionMessage)
power <- coef(lm(log(force) ~ log(depth), data = curve))[[2]]
cat(sprintf("F = %.4f mN at %.0f nm, F ~ d^%.2f, largest relative error %.1e\n", 1e3 * curve$force[50], 1e9 * depth[50], power, largest))
stopifnot(largest < 1e-6, grepl("compiled up to", refused), power > 1.4, power < 1.7)

package org.maestro.language.wording;

import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.Formula;

/**
 * What somebody has asked for, as it is told.
 *
 * @param goal what is to be so; empty when it is no formula
 * @param said in which words; empty when it was not said in words
 * @param by the person, by her name in the home; empty when that is not known
 * @param ago how long ago
 */
public record Wish(
    Optional<Formula> goal, Optional<String> said, Optional<String> by, Duration ago) {}

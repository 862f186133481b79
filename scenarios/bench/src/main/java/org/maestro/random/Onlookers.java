package org.maestro.random;

import java.util.List;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * Honest observers at one moment, and whether any could have seen that a goal is not so.
 *
 * @param believed by the platform: there it could have had somebody look
 */
record Onlookers(Site site, Moment moment, Possibilities possibilities, Snapshot believed) {

  /**
   * @param goal spelled out, and false
   */
  boolean couldTell(Formula goal) {
    return SpelledOut.cases(goal).stream().allMatch(this::couldTellOne);
  }

  private boolean couldTellOne(List<Formula> parts) {
    Truths truths = new Truths(moment, site);
    return parts.stream()
        .filter(part -> truths.of(part) == Truths.Grade.FALSE)
        .anyMatch(this::canBeLookedAt);
  }

  private boolean canBeLookedAt(Formula part) {
    if (part instanceof Formula.Comparison comparison) {
      return Truths.Constraint.of(comparison).isOfLight() && possibilities.isMeasured(comparison);
    }
    Formula positive = part instanceof Formula.Not not ? not.operand() : part;
    Formula.Atom atom = (Formula.Atom) positive;
    List<Term> arguments = atom.arguments();
    return switch (atom.predicate()) {
      case "in" -> isWatched(Truths.name(arguments, 1));
      case "nextTo" -> arguments.stream().anyMatch(this::isWatchedWhereBelieved);
      case "canSee" -> possibilities.isUsable(Truths.name(arguments, 0));
      default -> false;
    };
  }

  /** What is in a hand no camera sees. */
  private boolean isWatched(String place) {
    return site.floor().isZone(place) && possibilities.canLook(place);
  }

  /** What is believed to be nowhere could have been looked for. */
  private boolean isWatchedWhereBelieved(Term thing) {
    return believed
        .value("in", List.of(thing))
        .map(place -> isWatched(((Term.Name) place).text()))
        .orElse(true);
  }
}

package org.maestro.ontology.home;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * How the persons of a home are followed, by one agent for all of its rooms (ADE, 5; A74).
 * Immutable.
 *
 * @param agent the agent's name
 * @param tracked the class of those whom it follows
 * @param words the facts that it tells
 * @param ways over {@code ?a} and {@code ?b}: whether one goes from one zone straight to the other
 * @param waysOut zones by which persons leave the home; empty: any
 * @param habits how persons are assumed to move about
 * @param sureFrom the probability from which on it tells where somebody is
 * @param foretellsFrom the probability from which on it tells where somebody is heading
 * @param cues the kinds of facts from which it concludes
 */
public record PersonTracking(
    String agent,
    String tracked,
    Words words,
    Formula ways,
    Set<String> waysOut,
    Habits habits,
    double sureFrom,
    double foretellsFrom,
    List<PersonCue> cues) {

  /**
   * Facts over {@code ?person} and {@code ?zone}.
   *
   * @param is where somebody surely is
   * @param probablyIs where somebody is more likely than not
   * @param heading where somebody is likely to go next
   * @param guest where somebody is who is not followed, over {@code ?zone} alone
   */
  public record Words(
      Formula.Atom is,
      Optional<Formula.Atom> probablyIs,
      Optional<Formula.Atom> heading,
      Optional<Formula.Atom> guest) {}

  /**
   * How persons move about, assumed.
   *
   * @param stay in a zone, in the mean
   * @param absence of who has left the home, in the mean
   * @param passage who has not gone on from a zone by then stays there
   * @param guestShare how likely somebody who is not followed is in a zone, 0 to 1
   */
  public record Habits(Duration stay, Duration absence, Duration passage, double guestShare) {}

  public PersonTracking {
    waysOut = Collections.unmodifiableSet(new TreeSet<>(waysOut));
    cues = List.copyOf(cues);
  }

  /** The fact that the person was heard to speak in the zone, if that is a cue. */
  public Optional<Formula.Atom> heard(String person, String zone) {
    Substitution there =
        new Substitution(
            Map.of(PersonCue.PERSON, new Term.Name(person), PersonCue.ZONE, new Term.Name(zone)));
    return cues.stream().filter(PersonCue::spoken).map(cue -> there.apply(cue.fact())).findFirst();
  }

  /** The same question of where somebody probably is; empty if it does not ask where one is. */
  public Optional<Formula> supposed(Formula asked) {
    if (words.probablyIs().isEmpty()) {
      return Optional.empty();
    }
    Formula supposed = new Supposition(words.is(), words.probablyIs().get()).of(asked);
    return supposed.equals(asked) ? Optional.empty() : Optional.of(supposed);
  }
}

package org.maestro.coordination.facts;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.belief.AsClaimed;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The witnesses who have seen or measured what a goal rests on, and those who only say so: a step's
 * result and a device's own state are the word of the one that did it, and no witness of it.
 */
final class Testimony {
  private final Snapshot snapshot;
  private final Home home;
  private final Vocabulary vocabulary;
  private final Instant notBefore;

  /**
   * @param notBefore what was observed earlier bears no witness any more
   */
  Testimony(Snapshot snapshot, Home home, Instant notBefore) {
    this.snapshot = snapshot;
    this.home = home;
    this.vocabulary = home.vocabulary();
    this.notBefore = notBefore;
  }

  /** Whether one of them is a witness who has lately observed that the condition holds. */
  boolean isWitnessed(List<Belief> claims, String name, Formula condition) {
    return claims.stream()
        .anyMatch(
            said ->
                isWitness(said, name)
                    && !isOld(said, name)
                    && truth(said, condition) == Truth.TRUE);
  }

  /** Whether a witness has lately seen the thing where it may be, if the condition holds. */
  boolean isSeen(List<Belief> places, Formula condition) {
    return places.stream()
        .anyMatch(
            said ->
                isWitness(said, OnlyExpected.POSITION)
                    && !isOld(said, OnlyExpected.POSITION)
                    && truth(said, condition) != Truth.FALSE);
  }

  /**
   * What witnesses have observed since that does not agree with the condition, and what those say
   * who would tell if it had become so.
   */
  List<Belief> denials(List<Belief> claims, String name, Formula condition, Instant since) {
    return claims.stream()
        .filter(said -> isWitness(said, name))
        .filter(said -> isKeptUp(said) || !said.since().isBefore(since))
        .filter(said -> truth(said, condition) == Truth.FALSE)
        .toList();
  }

  /** Whether it is a member's own state, which it tells anew when it changes. */
  private boolean isKeptUp(Belief said) {
    return said.source().kind() == Source.Kind.STATED
        && home.devices().containsKey(said.source().agent());
  }

  /**
   * Whether the source has looked for itself. Who only failed at a step for the sake of something
   * is no witness of it; who tells of itself is one only of what none of its own steps changes.
   */
  boolean isWitness(Belief said, String name) {
    Optional<Device> device = Optional.ofNullable(home.devices().get(said.source().agent()));
    return switch (said.source().kind()) {
      case DESCRIBED -> true;
      case EXPECTED -> false;
      case STATED -> device.filter(member -> changes(member, name)).isEmpty();
      case OBSERVED -> device.isEmpty() || observes(device.get(), name);
    };
  }

  /** Whether it was observed so long ago that somebody may have changed it, and can be again. */
  boolean isOld(Belief said, String name) {
    return said.source().kind() == Source.Kind.OBSERVED
        && notBefore.isAfter(said.since())
        && (isNumber(name) || isDecidedByLooks(name) || isSensed(name));
  }

  private boolean observes(Device device, String name) {
    return device.features().stream()
        .map(FeatureType::effect)
        .anyMatch(
            effect ->
                isNumber(name) ? Sensing.names(effect).contains(name) : Sensing.isOfAtoms(effect));
  }

  /** Whether a device of the home has a feature that changes it. */
  boolean isChangedBySomebody(String name) {
    return home.devices().values().stream().anyMatch(device -> changes(device, name));
  }

  /** Who changes anything that positions decide tells of positions as a doer. */
  private boolean changes(Device device, String name) {
    for (FeatureType feature : device.features()) {
      Set<String> changed = Symbols.changedBy(feature.effect());
      changed.removeAll(Sensing.names(feature.effect()));
      if (changed.contains(name)
          || name.equals(OnlyExpected.POSITION)
              && changed.stream().anyMatch(this::isDecidedByLooks)) {
        return true;
      }
    }
    return false;
  }

  private boolean isNumber(String name) {
    return vocabulary.isFluent(name);
  }

  private boolean isDecidedByLooks(String name) {
    return name.equals(OnlyExpected.POSITION)
        || vocabulary.predicate(name).filter(p -> p.observedWhen().isPresent()).isPresent();
  }

  private boolean isSensed(String name) {
    return home.devices().values().stream()
        .flatMap(device -> device.features().stream())
        .anyMatch(feature -> Sensing.names(feature.effect()).contains(name));
  }

  /** What the claim alone says of an atom, and what becomes of a comparison if it is so. */
  private Truth truth(Belief said, Formula condition) {
    AsClaimed claimed = new AsClaimed(snapshot, home, said);
    if (condition instanceof Formula.Atom atom) {
      return claimed.tells(atom);
    } else if (condition instanceof Formula.Not not && not.operand() instanceof Formula.Atom atom) {
      Truth told = claimed.tells(atom);
      return told == Truth.UNKNOWN ? told : Truth.of(told == Truth.FALSE);
    }
    return new Evaluation(claimed).truth(condition, Map.of());
  }

  /** All that is said of where the thing is. */
  List<Belief> ofPlace(Term thing) {
    return snapshot.claims(
        new Formula.Atom(OnlyExpected.POSITION, List.of(thing, new Term.Text(""))));
  }
}

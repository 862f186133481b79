package org.maestro.knowledge.learning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.Moment;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.knowledge.belief.Declarations;
import org.maestro.knowledge.belief.FactReader;
import org.maestro.knowledge.belief.LastWords;
import org.maestro.knowledge.belief.OwnReports;
import org.maestro.knowledge.belief.World;
import org.maestro.ontology.home.Device;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The reports of a member itself on what its step changes, set against what the effect predicts.
 * What it reported after the step stands. What it reported while the step went on stands too,
 * unless it is only what was known before: then the effect was still to come.
 */
final class OwnWord {

  /** By which share two readings of the same number may differ: five deviations of 1 %. */
  static final double NOISE = 0.05;

  /** By which share sums may differ that are the same. */
  private static final double ROUNDING = 1e-6;

  /** The verdict on a fact that the effect predicts. */
  enum Verdict {
    /** It is as predicted, as far as the member has said. */
    PREDICTED,
    /** The member's own word stands. */
    OWN_WORD,
    /** The member's own word stands, which knows of the step and says that it is not so. */
    DENIED,
    /**
     * The member's word stands above the prediction; but it may have been said before all was done.
     */
    OWN_WORD_FOR_NOW,
    /** The member has spoken of it later, and that is known already. */
    SPOKEN_SINCE,
    /** Steps overlap, and nobody can tell whose share is in the member's word. */
    OPEN
  }

  private final World world;
  private final LastWords lastWords;
  private final FeatureRun run;
  private final Optional<MemberWord> last;
  private final Map<StateVariable, List<Fact>> said = new LinkedHashMap<>();

  OwnWord(World world, LastWords lastWords, FeatureRun run) {
    this.world = world;
    this.lastWords = lastWords;
    this.run = run;
    this.last = run.account().flatMap(this::lastBeforeTheEnd);
    for (Fact fact : read(last, run.member())) {
      StateVariable variable = world.declarations().spokenOf(fact);
      said.computeIfAbsent(variable, v -> new ArrayList<>()).add(fact);
    }
  }

  /** A state that was sent before the result may have been heard after it, and known before it. */
  private Optional<MemberWord> lastBeforeTheEnd(StepAccount account) {
    Optional<MemberWord> late =
        lastWords
            .lastHeard(run.member())
            .filter(word -> !word.moment().isAfter(account.tellsOfTheEnd()))
            .filter(word -> word.moment().isAfter(account.begun()))
            .filter(word -> account.last().filter(own -> !isAfter(word, own)).isEmpty());
    return late.isPresent() ? late : account.last();
  }

  private static boolean isAfter(MemberWord one, MemberWord other) {
    return one.moment().isAfter(other.moment());
  }

  /**
   * What cannot be read is refused where it is told for itself; it is no reason to learn nothing.
   */
  private static List<Fact> read(Optional<MemberWord> word, String member) {
    try {
      return word.stream()
          .flatMap(said -> said.facts().stream())
          .map(text -> FactReader.read(text, member))
          .toList();
    } catch (KnowledgeException e) {
      return List.of();
    }
  }

  /** What the step adds to: where the member has spoken since it began, what was known before. */
  OptionalDouble base(Expression.Fluent fluent, Snapshot present) {
    StateVariable variable = new StateVariable(fluent.name(), fluent.arguments());
    if (isSaidSinceBegun(variable)) {
      return before(fluent);
    }
    return isNews(variable) ? number(variable) : present.number(fluent);
  }

  private OptionalDouble before(Expression.Fluent fluent) {
    return run.before().map(known -> known.number(fluent)).orElse(OptionalDouble.empty());
  }

  /** What the member said of it last, where that is not known yet. */
  List<Fact> news(StateVariable variable) {
    return isNews(variable) ? saidOf(variable) : List.of();
  }

  /** What the member said of it last. */
  List<Fact> saidOf(StateVariable variable) {
    return said.getOrDefault(variable, List.of());
  }

  Verdict verdict(StateVariable variable, Fact predicted) {
    if (isSpokenSince(variable)) {
      return isTaughtLast(variable) ? Verdict.OPEN : Verdict.SPOKEN_SINCE;
    }
    if (isLeftOut(variable, predicted)) {
      return Verdict.SPOKEN_SINCE;
    }
    if (!isSaidSinceBegun(variable)) {
      return Verdict.PREDICTED;
    }
    if (isOverlapped(variable)) {
      return Verdict.OPEN;
    }
    List<Fact> words = saidOf(variable);
    if (words.stream().noneMatch(word -> knowsBetter(word, predicted))) {
      return Verdict.PREDICTED;
    }
    if (includesStep() && words.stream().anyMatch(word -> contradicts(word, predicted))) {
      return Verdict.DENIED;
    }
    boolean isSure = includesStep() || words.stream().allMatch(word -> isSame(word, predicted));
    return isSure ? Verdict.OWN_WORD : Verdict.OWN_WORD_FOR_NOW;
  }

  private static boolean isSame(Fact word, Fact predicted) {
    return distance(word, predicted).filter(distance -> distance <= ROUNDING).isPresent();
  }

  /** Whether the member has said just that since the step began. */
  boolean agrees(StateVariable variable, Fact predicted) {
    return isSaidSinceBegun(variable) && saidOf(variable).contains(predicted);
  }

  private boolean includesStep() {
    return run.account().filter(StepAccount::includesStep).isPresent();
  }

  /** Whether another step of the member has taught of it, of which the word knows or not. */
  private boolean isOverlapped(StateVariable variable) {
    StepAccount account = run.account().orElseThrow();
    Moment word = last.orElseThrow().moment();
    return lastWords
        .lastTaught(run.member(), variable)
        .filter(last -> last.isAfter(account.includesStep() ? word : account.begun()))
        .isPresent();
  }

  private boolean isSpokenSince(StateVariable variable) {
    return run.account()
        .flatMap(
            account ->
                lastWords
                    .last(run.member(), variable)
                    .filter(last -> last.isAfter(account.tellsOfTheEnd())))
        .isPresent();
  }

  /** Whether what is known of it later is not the member's word, but what another step taught. */
  private boolean isTaughtLast(StateVariable variable) {
    return lastWords
        .lastTaught(run.member(), variable)
        .equals(lastWords.last(run.member(), variable));
  }

  /** Whether a state that was said knowing of the step would name it, if it were so. */
  private boolean isLeftOut(StateVariable variable, Fact predicted) {
    if (!(predicted instanceof Fact.Holds holds)
        || run.account().isEmpty()
        || !wouldTell(holds.atom())) {
      return false;
    }
    Moment end = run.account().get().tellsOfTheEnd();
    boolean heardSince =
        lastWords.lastHeard(run.member()).filter(heard -> heard.moment().isAfter(end)).isPresent();
    return heardSince || includesStep() && !said.containsKey(variable);
  }

  private boolean wouldTell(Formula.Atom atom) {
    Device device = world.home().devices().get(run.member());
    return device != null && new OwnReports(device).wouldTell(atom);
  }

  private boolean isSaidSinceBegun(StateVariable variable) {
    return said.containsKey(variable)
        && (includesStep()
            || last.stream().anyMatch(word -> word.moment().isAfter(run.account().get().begun())));
  }

  private boolean isNews(StateVariable variable) {
    Optional<Moment> moment = last.map(MemberWord::moment);
    return said.containsKey(variable)
        && moment.isPresent()
        && lastWords
            .last(run.member(), variable)
            .filter(last -> last.isAfter(moment.get()))
            .isEmpty();
  }

  /**
   * Whether the prediction gives way to the word; a result that tells of itself is no prediction,
   * and stands unless the member contradicts itself.
   */
  private boolean knowsBetter(Fact word, Fact predicted) {
    if (predicted instanceof Fact.Unknown) {
      return true;
    }
    if (run.feature().learns().isPresent()) {
      return includesStep() && contradicts(word, predicted);
    }
    if (predicted instanceof Fact.Equation equation) {
      return includesStep() || word instanceof Fact.Equation own && isNeither(own, equation);
    }
    return contradicts(word, predicted) && (includesStep() || !wasKnownBefore(word));
  }

  /** A number that shows less than half of the step's share is that of before. */
  private boolean isNeither(Fact.Equation own, Fact.Equation predicted) {
    OptionalDouble before = before(predicted.fluent());
    if (before.isEmpty()
        || !(own.value() instanceof Term.Number said)
        || !(predicted.value() instanceof Term.Number expected)) {
      return true;
    }
    double share = expected.value() - before.getAsDouble();
    double shown = said.value() - before.getAsDouble();
    return Math.abs(shown) >= Math.abs(share) / 2;
  }

  /** Of numbers that a step changes nobody says how near is near enough. */
  private boolean contradicts(Fact fact, Fact predicted) {
    if (run.feature().learns().isPresent() && areFarApart(fact, predicted)) {
      return true;
    }
    if (!isSymbol(fact) || !isSymbol(predicted)) {
      return false;
    }
    Declarations declarations = world.declarations();
    Term value = declarations.valueOf(declarations.canonical(FactReader.atom(fact)));
    Term other = declarations.valueOf(declarations.canonical(FactReader.atom(predicted)));
    boolean holds = fact instanceof Fact.Holds;
    boolean predictedToHold = predicted instanceof Fact.Holds;
    return holds && predictedToHold
        ? !value.equals(other)
        : holds != predictedToHold && value.equals(other);
  }

  /** Whether they are no readings of the same number. */
  private static boolean areFarApart(Fact one, Fact other) {
    return distance(one, other).filter(distance -> distance > NOISE).isPresent();
  }

  /** How far two numbers are from each other, as a share of the larger; empty: they are none. */
  private static Optional<Double> distance(Fact one, Fact other) {
    return one instanceof Fact.Equation first
            && other instanceof Fact.Equation second
            && first.value() instanceof Term.Number a
            && second.value() instanceof Term.Number b
        ? Optional.of(distance(a.value(), b.value()))
        : Optional.empty();
  }

  private static double distance(double one, double other) {
    double difference = Math.abs(one - other);
    return difference <= ROUNDING ? 0 : difference / Math.max(Math.abs(one), Math.abs(other));
  }

  private static boolean isSymbol(Fact fact) {
    return fact instanceof Fact.Holds || fact instanceof Fact.Excluded;
  }

  private boolean wasKnownBefore(Fact fact) {
    Formula.Atom atom = FactReader.atom(fact);
    Truth then =
        run.before()
            .map(known -> new Evaluation(known).truth(atom, Map.of()))
            .orElse(Truth.UNKNOWN);
    return then == Truth.of(fact instanceof Fact.Holds);
  }

  private OptionalDouble number(StateVariable variable) {
    return saidOf(variable).stream()
        .filter(fact -> fact instanceof Fact.Equation own && own.value() instanceof Term.Number)
        .mapToDouble(fact -> ((Term.Number) ((Fact.Equation) fact).value()).value())
        .findFirst();
  }
}

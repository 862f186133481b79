package org.maestro.knowledge.learning;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.knowledge.belief.Cell;
import org.maestro.knowledge.belief.Declarations;
import org.maestro.knowledge.belief.Draft;
import org.maestro.knowledge.belief.FactReader;
import org.maestro.knowledge.belief.LastWords;
import org.maestro.knowledge.belief.PositionKeeping;
import org.maestro.knowledge.belief.World;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Effect;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The facts that the result of a feature teaches. */
public final class Lesson {

  private final World world;
  private final Snapshot present;
  private final FeatureRun run;
  private final LastWords lastWords;
  private final OwnWord own;
  private final List<Fact> ownWords = new ArrayList<>();
  private final Set<Fact> reported = new LinkedHashSet<>();
  private final Set<Fact> denials = new LinkedHashSet<>();

  public Lesson(World world, Snapshot present, FeatureRun run, LastWords lastWords) {
    this.world = world;
    this.present = present;
    this.run = run;
    this.lastWords = lastWords;
    this.own = new OwnWord(world, lastWords, run);
  }

  /** A result without lesson of its own lets expect the effect; all else was observed. */
  public Source source() {
    boolean expects = run.succeeded() && run.feature().learns().isEmpty();
    return new Source(expects ? Source.Kind.EXPECTED : Source.Kind.OBSERVED, run.member());
  }

  /**
   * The facts to write.
   *
   * @param positions is told first what a failure leaves unknown
   */
  public List<Fact> facts(Draft draft, PositionKeeping positions) {
    Consumer<StateVariable> forget = positions::forget;
    Snapshot before = run.before().orElse(present);
    FeatureType feature = run.feature();
    Map<String, Term> bindings = Self.is(run.member(), run.bindings());
    if (run.succeeded()) {
      bindings.putAll(ResultCheck.sound(feature, run.outputs()));
      Snapshot read = feature.learns().isPresent() ? present : before;
      Effect effect = feature.learns().orElse(feature.effect());
      List<Fact> facts = new ArrayList<>();
      List<Fact> predicted = new ArrayList<>();
      Set<StateVariable> told = new LinkedHashSet<>();
      for (Fact fact :
          EffectReader.facts(effect, bindings, read, fluent -> own.base(fluent, present))) {
        StateVariable variable = world.declarations().spokenOf(fact);
        switch (own.verdict(variable, fact)) {
          case PREDICTED -> {
            ownWords.addAll(own.news(variable));
            if (own.agrees(variable, fact)) {
              reported.add(fact);
            }
            predicted.add(fact);
          }
          case OWN_WORD -> {
            ownWords.addAll(own.news(variable));
            reported.addAll(own.news(variable));
          }
          case DENIED -> {
            ownWords.addAll(own.news(variable));
            denials.addAll(own.saidOf(variable));
          }
          case OWN_WORD_FOR_NOW -> {
            forget.accept(variable);
            facts.addAll(own.news(variable));
            reported.addAll(own.news(variable));
          }
          case SPOKEN_SINCE -> {
            // What is known of it is later than the step.
          }
          case OPEN -> forget.accept(variable);
        }
        told.add(variable);
      }
      for (Fact fact : predicted) {
        if (denials.isEmpty() || reported.contains(fact)) {
          predicted(fact, before, facts, forget);
        } else {
          leaveOpen(world.declarations().spokenOf(fact), positions);
        }
      }
      run.account()
          .map(StepAccount::tellsOfTheEnd)
          .ifPresent(ended -> told.forEach(v -> lastWords.taught(run.member(), v, ended)));
      return facts;
    }
    if (run.begun()) {
      EffectReader.touched(feature.effect(), bindings, before).stream()
          .map(draft::variable)
          .forEach(variable -> leaveOpen(variable, positions));
    }
    return run.refs().stream().map(ref -> FactReader.read(ref, run.member())).toList();
  }

  /** A step that was not done as it was to be leaves open what it may have changed. */
  private void leaveOpen(StateVariable variable, PositionKeeping positions) {
    if (!isUncertain(variable.predicate()) || isOwnWord(variable)) {
      return;
    }
    if (lastWords.isLost(run.member())) {
      positions.forget(variable);
    } else {
      positions.forgetAllBut(ownSource(), variable);
    }
  }

  /** What the member itself said of what the step changes; to be written before the facts. */
  public List<Fact> ownWords() {
    return List.copyOf(ownWords);
  }

  /** What the member has told of the step's doing; it may have been known already. */
  public List<String> reported() {
    return reported.stream().filter(fact -> !wasKnown(fact)).map(SlPrinter::print).toList();
  }

  /**
   * What the member has told, knowing of the step, that is otherwise than the step was to make it.
   */
  public List<String> denials() {
    return denials.stream().map(SlPrinter::print).toList();
  }

  private boolean wasKnown(Fact fact) {
    Formula.Atom atom = FactReader.atom(fact);
    Snapshot before = run.before().orElse(present);
    return fact instanceof Fact.Equation equation
        ? equation.value() instanceof Term.Number number
            && before.number(equation.fluent()).equals(OptionalDouble.of(number.value()))
        : before.truth(atom) == Truth.of(fact instanceof Fact.Holds);
  }

  /** As predicted, unless somebody else has measured it meanwhile. */
  private void predicted(
      Fact fact, Snapshot before, List<Fact> facts, Consumer<StateVariable> forget) {
    StateVariable variable = world.declarations().spokenOf(fact);
    if (isBelowAll(fact)) {
      forget.accept(variable);
      return;
    }
    switch (meanwhile(fact, before)) {
      case NOTHING -> facts.add(fact);
      case SHARE -> {
        // To add it again would count it twice.
      }
      case MORE -> forget.accept(variable);
    }
  }

  /** What was known of the number, or of what the step does to it, was not so. */
  private boolean isBelowAll(Fact fact) {
    return fact instanceof Fact.Equation equation
        && equation.value() instanceof Term.Number expected
        && expected.value() < world.declarations().least(equation.fluent().name());
  }

  /** The reading of a sensor while a step ran: what it shows of the step's share of a number. */
  private enum Meanwhile {
    /** It read before the step had its effect, or not at all. */
    NOTHING,
    /** The share is in it. */
    SHARE,
    /** Others have changed the number too: nobody can tell how much of the share is in it. */
    MORE
  }

  /** A reading that shows less than half of the share was taken before the step had its effect. */
  private Meanwhile meanwhile(Fact fact, Snapshot before) {
    if (!(fact instanceof Fact.Equation equation)
        || !(equation.value() instanceof Term.Number expected)
        || run.feature().learns().isPresent()) {
      return Meanwhile.NOTHING;
    }
    Optional<Belief> measured =
        present
            .belief(equation.fluent())
            .filter(belief -> isOfAnother(belief.source()))
            .filter(belief -> !before.belief(equation.fluent()).equals(Optional.of(belief)));
    OptionalDouble then = before.number(equation.fluent());
    OptionalDouble now = present.number(equation.fluent());
    if (measured.isEmpty() || then.isEmpty() || now.isEmpty()) {
      return Meanwhile.NOTHING;
    }
    OptionalDouble base = own.base(equation.fluent(), present);
    double share = expected.value() - base.orElse(now.getAsDouble());
    double shown = now.getAsDouble() - then.getAsDouble();
    if (share * shown <= 0 || Math.abs(shown) < Math.abs(share) / 2) {
      return Meanwhile.NOTHING;
    }
    double more = Math.abs(shown) - Math.abs(share);
    return more > Math.abs(share) / 2 && more > OwnWord.NOISE * Math.abs(now.getAsDouble())
        ? Meanwhile.MORE
        : Meanwhile.SHARE;
  }

  /** Whether somebody has observed it, or a sensor tells it of its own accord. */
  private boolean isOfAnother(Source source) {
    return source.kind() == Source.Kind.OBSERVED
        || source.kind() == Source.Kind.STATED && !source.agent().equals(run.member());
  }

  /** Whether a step that failed leaves it open; plain closed-world facts stay as they are. */
  private boolean isUncertain(String predicate) {
    Declarations declarations = world.declarations();
    return declarations.isFluent(predicate)
        || declarations.isFunctional(predicate)
        || declarations.isObservable(predicate);
  }

  /**
   * A member goes on telling what it tells of itself, whatever became of the step: its own values,
   * and what it holds. One that is lost does not.
   */
  private boolean isOwnWord(StateVariable variable) {
    return !lastWords.isLost(run.member())
        && world
            .cell(variable)
            .flatMap(Cell::value)
            .filter(held -> held.source().equals(ownSource()))
            .isPresent();
  }

  private Source ownSource() {
    return new Source(Source.Kind.STATED, run.member());
  }
}

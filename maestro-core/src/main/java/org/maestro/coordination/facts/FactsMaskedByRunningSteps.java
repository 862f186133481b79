package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The known facts, with what steps under way are changing as it was when these steps began. While a
 * robot grasps a cup, a camera loses sight of it: that is the step at work, not news. The step's
 * own report will say how it ended. And a plan is not to look for what is looked for beside it.
 */
public final class FactsMaskedByRunningSteps implements Facts {
  private final Snapshot now;
  private final Vocabulary vocabulary;
  private final List<Handled> handled = new ArrayList<>();
  private final Set<Formula.Atom> soughtBeside = new HashSet<>();

  /**
   * A name with arguments; of a state variable, without its value.
   *
   * @param hash of both, as it is looked for in what many steps are changing
   */
  record Subject(String name, List<Term> arguments, int hash) {
    Subject(String name, List<Term> arguments) {
      this(name, arguments, 31 * name.hashCode() + arguments.hashCode());
    }

    @Override
    public int hashCode() {
      return hash;
    }
  }

  /**
   * The subjects that a step is just changing, and what was known before.
   *
   * @param spokenOf the subjects as changes tell them
   */
  public record Handled(
      Set<Subject> subjects, Map<String, Set<String>> spokenOf, Snapshot before) {}

  public FactsMaskedByRunningSteps(Snapshot now, Vocabulary vocabulary) {
    this.now = now;
    this.vocabulary = vocabulary;
  }

  public void add(Handled beside) {
    handled.add(beside);
  }

  /**
   * As long as nobody knows whether they are so, these count as not so. Who has plans made with it
   * has to await those looks before he says that there is none.
   */
  public void addSoughtBeside(Set<Formula.Atom> atoms) {
    soughtBeside.addAll(atoms);
  }

  private Truth sought(Formula.Atom atom, Truth known) {
    return known == Truth.UNKNOWN && soughtBeside.contains(atom) ? Truth.FALSE : known;
  }

  /** Whether any of what has changed is told here as it was before. */
  boolean hides(FactFilter changed) {
    return handled.stream().anyMatch(beside -> changed.speaksOfAny(beside.spokenOf()));
  }

  /** The step is under way since the given moment. */
  public Handled handled(Step step, Snapshot before) {
    Set<Subject> subjects = new HashSet<>();
    for (Change change : new Evaluation(before).changes(step.feature().effect(), step.values())) {
      if (change instanceof Change.OfTruth truth) {
        subjects.add(subject(truth.atom()));
        subjects.add(subject(mirrored(truth.atom())));
      } else if (change instanceof Change.OfNumber number
          && number.fluent().arguments().contains(new Term.Name(step.member()))) {
        subjects.add(subject(number.fluent()));
      }
    }
    Map<String, Set<String>> spokenOf = new HashMap<>();
    subjects.forEach(
        subject ->
            spokenOf
                .computeIfAbsent(subject.name(), name -> new HashSet<>())
                .add(FactFilter.told(subject.arguments())));
    return new Handled(subjects, spokenOf, before);
  }

  private Subject subject(Formula.Atom atom) {
    boolean functional =
        vocabulary.predicate(atom.predicate()).filter(PredicateDeclaration::functional).isPresent();
    List<Term> arguments = atom.arguments();
    return new Subject(
        atom.predicate(), functional ? arguments.subList(0, arguments.size() - 1) : arguments);
  }

  /** A symmetric predicate may be asked for the other way round. */
  private Formula.Atom mirrored(Formula.Atom atom) {
    boolean symmetric =
        vocabulary.predicate(atom.predicate()).filter(PredicateDeclaration::symmetric).isPresent();
    return symmetric
        ? new Formula.Atom(
            atom.predicate(), List.of(atom.arguments().get(1), atom.arguments().get(0)))
        : atom;
  }

  /**
   * Numbers that several steps add to are told as they are; only a member's own wait for its
   * report.
   */
  private static Subject subject(Expression.Fluent fluent) {
    return new Subject(fluent.name(), fluent.arguments());
  }

  private Snapshot source(Subject subject) {
    for (Handled beside : handled) {
      if (beside.subjects().contains(subject)) {
        return beside.before();
      }
    }
    return now;
  }

  private boolean isHandled(String name) {
    return handled.stream().anyMatch(beside -> beside.spokenOf().containsKey(name));
  }

  /** Each answer rests on what is asked too: steps may begin or cease to change it. */
  @Override
  public Optional<Facts> tracing(Consumer<Object> told) {
    boolean all =
        Stream.concat(Stream.of(now), handled.stream().map(Handled::before))
            .allMatch(snapshot -> snapshot.tracing(told).isPresent());
    return all ? Optional.of(new Traced(this, told)) : Optional.empty();
  }

  /** Tells on what each answer rests. */
  private record Traced(FactsMaskedByRunningSteps facts, Consumer<Object> told) implements Facts {

    private Facts source(Subject subject) {
      told.accept(subject);
      return facts.source(subject).tracing(told).orElseThrow();
    }

    @Override
    public Truth truth(Formula.Atom atom) {
      return facts.sought(atom, source(facts.subject(atom)).truth(atom));
    }

    @Override
    public OptionalDouble number(Expression.Fluent fluent) {
      return source(subject(fluent)).number(fluent);
    }

    /** Once a step changes it, each atom has to be asked for. */
    @Override
    public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
      told.accept(new Subject(atom.predicate(), List.of()));
      return facts.isHandled(atom.predicate())
          ? Optional.empty()
          : facts.now.tracing(told).orElseThrow().candidates(atom, variable);
    }

    @Override
    public double chanceStill(Formula.Atom atom) {
      return facts.chanceStill(atom);
    }

    @Override
    public Collection<Term.Name> individuals(String className) {
      return facts.individuals(className);
    }
  }

  /** What a step is changing is as before until the step has ended. */
  @Override
  public Optional<Set<Object>> changedSince(Facts other) {
    return other instanceof FactsMaskedByRunningSteps before
            && common(handled, before.handled).equals(common(before.handled, handled))
        ? now.changedSince(before.now).map(changed -> withOthersThan(before, changed))
        : Optional.empty();
  }

  private Set<Object> withOthersThan(FactsMaskedByRunningSteps before, Set<Object> changed) {
    Set<Object> all = new LinkedHashSet<>(changed);
    Stream.concat(
            handled.stream().filter(one -> !before.handled.contains(one)),
            before.handled.stream().filter(one -> !handled.contains(one)))
        .forEach(
            one -> {
              all.addAll(one.subjects());
              one.subjects().forEach(subject -> all.add(new Subject(subject.name(), List.of())));
            });
    Stream.concat(
            soughtBeside.stream().filter(atom -> !before.soughtBeside.contains(atom)),
            before.soughtBeside.stream().filter(atom -> !soughtBeside.contains(atom)))
        .forEach(atom -> all.add(subject(atom)));
    return all;
  }

  private static List<Handled> common(List<Handled> some, List<Handled> others) {
    return some.stream().filter(others::contains).toList();
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    return sought(atom, source(subject(atom)).truth(atom));
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    return source(subject(fluent)).number(fluent);
  }

  @Override
  public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    return isHandled(atom.predicate()) ? Optional.empty() : now.candidates(atom, variable);
  }

  @Override
  public double chanceStill(Formula.Atom atom) {
    return now.chanceStill(atom);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return now.individuals(className);
  }
}

package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * The facts that a goal and its plan depend on, so that a change wakes only those whom it concerns.
 * A fact is told by its name and the first of its arguments that is no variable, {@code (canSee
 * ?agent Cup)} by the cup; one of variables alone stands for any. The value of a functional
 * predicate tells no fact: it is what changes. A change is told by all of its arguments.
 */
public final class FactFilter {
  private static final String ANY = "";
  private static final String POSITION = "position";

  private final Vocabulary vocabulary;
  private final Unfolding unfolding;
  private final Map<String, Set<String>> subjects = new TreeMap<>();

  public FactFilter(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
    this.unfolding = new Unfolding(vocabulary);
  }

  /** Names of individuals by the predicate or fluent that speaks of them; empty: of any. */
  public Map<String, Set<String>> subjects() {
    Map<String, Set<String>> copy = new TreeMap<>();
    subjects.forEach((name, names) -> copy.put(name, new TreeSet<>(names)));
    return copy;
  }

  /** Facts of which a condition speaks. */
  public static FactFilter ofReading(Formula condition, Vocabulary vocabulary) {
    FactFilter interest = new FactFilter(vocabulary);
    interest.addRead(condition);
    return interest;
  }

  /** What {@link #subjects} told. */
  public static FactFilter of(Map<String, Set<String>> subjects, Vocabulary vocabulary) {
    FactFilter interest = new FactFilter(vocabulary);
    subjects.forEach((name, names) -> interest.subjects.put(name, new TreeSet<>(names)));
    return interest;
  }

  /** The subjects of facts as a change tells them. */
  public static FactFilter of(List<String> facts, Vocabulary vocabulary) {
    FactFilter changed = new FactFilter(vocabulary);
    facts.forEach(
        fact ->
            Leaves.of(
                SlParser.formula(fact, vocabulary::isFluent),
                atom -> changed.addChanged(atom.predicate(), atom.arguments()),
                fluent -> changed.addChanged(fluent.name(), fluent.arguments())));
    return changed;
  }

  static FactFilter ofChanges(List<Change> changes, Vocabulary vocabulary) {
    FactFilter changed = new FactFilter(vocabulary);
    changed.addChanges(changes);
    return changed;
  }

  public void addChanges(List<Change> changes) {
    for (Change change : changes) {
      if (change instanceof Change.OfTruth truth) {
        addChanged(truth.atom().predicate(), truth.atom().arguments());
      } else if (change instanceof Change.OfNumber number) {
        addChanged(number.fluent().name(), number.fluent().arguments());
      }
    }
  }

  public void addAll(FactFilter other) {
    other.subjects.forEach(
        (name, names) -> subjects.computeIfAbsent(name, n -> new TreeSet<>()).addAll(names));
  }

  /** What the step needs to begin. */
  void addConditions(Step step) {
    Map<String, Term> bindings = step.values();
    add(step.feature().precondition(), bindings);
    step.feature().claims().forEach(claim -> add(claim.when(), bindings));
  }

  /** What the step's effect and price depend on. */
  void addEffects(Step step) {
    Map<String, Term> bindings = step.values();
    if (step.feature().cost() instanceof Price.Stated stated) {
      add(stated.cost(), bindings);
    }
    add(step.feature().effect(), bindings);
  }

  /** What a formula depends on. */
  public void addRead(Formula formula) {
    add(formula, Map.of());
  }

  void add(Formula formula, Map<String, Term> bindings) {
    unfolding
        .conjuncts(formula, bindings)
        .forEach(
            part ->
                Leaves.of(
                    part,
                    atom -> addRead(atom.predicate(), atom.arguments()),
                    fluent -> addRead(fluent.name(), fluent.arguments())));
  }

  /** What the value of an expression without variables depends on. */
  public void add(Expression expression) {
    add(expression, Map.of());
  }

  private void add(Expression expression, Map<String, Term> bindings) {
    Leaves.of(
        new Substitution(bindings).apply(expression),
        fluent -> addRead(fluent.name(), fluent.arguments()));
  }

  /** What an effect's conditions and values read, and where it hopes to find something. */
  private void add(Effect effect, Map<String, Term> bindings) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> add(part, bindings));
    } else if (effect instanceof Effect.When when) {
      add(when.condition(), bindings);
      add(when.effect(), bindings);
    } else if (effect instanceof Effect.Forall forall) {
      add(forall.effect(), bindings);
    } else if (effect instanceof Effect.Change change) {
      add(change.value(), bindings);
    } else if (effect instanceof Effect.SenseAtom sense) {
      add(sense.atom(), bindings);
    } else if (effect instanceof Effect.SenseNumber sense) {
      add(sense.fluent(), bindings);
    }
  }

  /** Geometry follows from where its arguments are; what positions decide, from the same. */
  private void addRead(String name, List<Term> arguments) {
    Optional<PredicateDeclaration> declared = vocabulary.predicate(name);
    int telling =
        declared.filter(PredicateDeclaration::functional).isPresent()
            ? arguments.size() - 1
            : arguments.size();
    boolean symmetric = isSymmetric(name);
    subjects
        .computeIfAbsent(name, n -> new TreeSet<>())
        .add(
            IntStream.range(0, telling)
                .filter(place -> arguments.get(place) instanceof Term.Name)
                .mapToObj(place -> subject(arguments.get(place), symmetric ? 0 : place))
                .findFirst()
                .orElse(ANY));
    declared
        .filter(FactFilter::isGeometric)
        .ifPresent(
            geometric ->
                arguments.forEach(
                    argument ->
                        subjects
                            .computeIfAbsent(POSITION, n -> new TreeSet<>())
                            .add(subject(argument, 0))));
  }

  private static boolean isGeometric(PredicateDeclaration declared) {
    return declared.computedBy().isPresent() || declared.observedWhen().isPresent();
  }

  private boolean isSymmetric(String name) {
    return vocabulary.predicate(name).filter(PredicateDeclaration::symmetric).isPresent();
  }

  private void addChanged(String name, List<Term> arguments) {
    boolean symmetric = isSymmetric(name);
    Set<String> names = subjects.computeIfAbsent(name, n -> new TreeSet<>());
    for (int place = 0; place < arguments.size(); place++) {
      names.add(subject(arguments.get(place), symmetric ? 0 : place));
    }
    if (arguments.isEmpty()) {
      names.add(ANY);
    }
  }

  /** The first place goes without saying. */
  private static String subject(Term argument, int place) {
    if (!(argument instanceof Term.Name name)) {
      return ANY;
    }
    return place == 0 ? name.text() : place + ":" + name.text();
  }

  /** How a change tells of whom a fact with these arguments is. */
  static String told(List<Term> arguments) {
    return arguments.isEmpty() ? ANY : subject(arguments.get(0), 0);
  }

  /** Whether a fact of that name and about the same is among these changes. */
  public boolean speaksOf(String name, List<Term> arguments) {
    return subjects.getOrDefault(name, Set.of()).contains(told(arguments));
  }

  /**
   * Whether any of these is.
   *
   * @param facts how changes tell of whom they are, by their names
   */
  boolean speaksOfAny(Map<String, Set<String>> facts) {
    return subjects.entrySet().stream()
        .anyMatch(
            mine -> {
              Set<String> others = facts.getOrDefault(mine.getKey(), Set.of());
              return mine.getValue().stream().anyMatch(others::contains);
            });
  }

  /** Whether any part of the formula is about what is among these changes. */
  public boolean speaksOf(String formula) {
    List<Boolean> found = new ArrayList<>();
    Leaves.of(
        SlParser.formula(formula, vocabulary::isFluent),
        atom -> found.add(speaksOf(atom.predicate(), atom.arguments())),
        fluent -> found.add(speaksOf(fluent.name(), fluent.arguments())));
    return found.contains(true);
  }

  /** Whether any of the changed facts is among those that matter here. */
  public boolean isConcernedBy(FactFilter changed) {
    return changed.subjects.keySet().stream()
            .anyMatch(name -> subjects.getOrDefault(name, Set.of()).contains(ANY))
        || isNamedBy(changed);
  }

  /** The same, without what matters here of any individual. */
  boolean isNamedBy(FactFilter changed) {
    return changed.subjects.entrySet().stream()
        .anyMatch(
            change ->
                change.getValue().stream()
                    .anyMatch(subjects.getOrDefault(change.getKey(), Set.of())::contains));
  }
}

package org.maestro.coordination.facts;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * A snapshot of what is known, with what nobody goes on observing as unknown. What a device says of
 * itself, and what stands in the home, needs no observer.
 */
public final class WatchedSnapshot implements Snapshot {
  private final Snapshot now;
  private final Vocabulary vocabulary;
  private final Set<String> watchable;
  private final Predicate<Formula.Atom> atomIsWatched;
  private final Predicate<Expression.Fluent> fluentIsWatched;

  public WatchedSnapshot(
      Snapshot now,
      Vocabulary vocabulary,
      Set<String> watchable,
      Predicate<Formula.Atom> atomIsWatched,
      Predicate<Expression.Fluent> fluentIsWatched) {
    this.now = now;
    this.vocabulary = vocabulary;
    this.watchable = watchable;
    this.atomIsWatched = atomIsWatched;
    this.fluentIsWatched = fluentIsWatched;
  }

  @Override
  public long version() {
    return now.version();
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    PredicateDeclaration declared = vocabulary.predicates().get(atom.predicate());
    if (declared != null && restsOnHidden(declared)) {
      Map<String, Term> bindings = new HashMap<>();
      for (int i = 0; i < Math.min(atom.arguments().size(), declared.parameters().size()); i++) {
        bindings.put(declared.parameters().get(i).name(), atom.arguments().get(i));
      }
      Truth derived = new Evaluation(this).truth(declared.derivedWhen().orElseThrow(), bindings);
      return derived == Truth.UNKNOWN && !declared.observable() ? Truth.FALSE : derived;
    }
    return isHidden(atom) ? Truth.UNKNOWN : now.truth(atom);
  }

  private boolean restsOnHidden(PredicateDeclaration declared) {
    return declared.derivedWhen().isPresent()
        && Symbols.of(declared.derivedWhen().get()).stream()
            .anyMatch(
                name ->
                    watchable.contains(name)
                        || vocabulary.predicate(name).filter(this::restsOnHidden).isPresent());
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    return isHidden(fluent) ? OptionalDouble.empty() : now.number(fluent);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return now.individuals(className);
  }

  @Override
  public Optional<Belief> belief(Formula.Atom atom) {
    return isHidden(atom) ? Optional.empty() : now.belief(atom);
  }

  @Override
  public Optional<Belief> belief(Expression.Fluent fluent) {
    return isHidden(fluent) ? Optional.empty() : now.belief(fluent);
  }

  @Override
  public List<Belief> claims(Formula.Atom atom) {
    return isHidden(atom) ? List.of() : now.claims(atom);
  }

  @Override
  public List<Belief> claims(Expression.Fluent fluent) {
    return isHidden(fluent) ? List.of() : now.claims(fluent);
  }

  @Override
  public Optional<Term> value(String predicate, List<Term> arguments) {
    return now.value(predicate, arguments);
  }

  @Override
  public List<Belief> beliefs() {
    return now.beliefs();
  }

  @Override
  public Optional<Belief> lastKnown(String predicate, List<Term> arguments) {
    return now.lastKnown(predicate, arguments);
  }

  @Override
  public Snapshot notOlderThan(Duration age) {
    return new WatchedSnapshot(
        now.notOlderThan(age), vocabulary, watchable, atomIsWatched, fluentIsWatched);
  }

  @Override
  public Snapshot witnessed(Consumer<Belief> witness) {
    return new WatchedSnapshot(
        now.witnessed(witness), vocabulary, watchable, atomIsWatched, fluentIsWatched);
  }

  @Override
  public Instant at() {
    return now.at();
  }

  @Override
  public List<Dispute> disputes() {
    return now.disputes();
  }

  private boolean isHidden(Formula.Atom atom) {
    return watchable.contains(atom.predicate())
        && !atomIsWatched.test(atom)
        && !needsNoObserver(now.belief(atom));
  }

  private boolean isHidden(Expression.Fluent fluent) {
    return watchable.contains(fluent.name())
        && !fluentIsWatched.test(fluent)
        && !needsNoObserver(now.belief(fluent));
  }

  private static boolean needsNoObserver(Optional<Belief> belief) {
    return belief
        .map(b -> b.source().kind())
        .filter(kind -> kind == Source.Kind.STATED || kind == Source.Kind.DESCRIBED)
        .isPresent();
  }
}

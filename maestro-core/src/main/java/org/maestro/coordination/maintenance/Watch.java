package org.maestro.coordination.maintenance;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.facts.Sensing;
import org.maestro.coordination.facts.Symbols;
import org.maestro.coordination.facts.WatchedSnapshot;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Effect;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * The continuous observation of what a held goal speaks of. It stays established as long as the
 * goal is held: what nobody goes on observing counts as unknown, so that a plan for the goal begins
 * with having it observed.
 */
final class Watch {
  private final Formula goal;
  private final Map<StepKey, Stream> streams = new LinkedHashMap<>();
  private @Nullable Home home;
  private Set<String> watchable = Set.of();

  /** The subject of a stream: an atom or fluent by name, of a state variable without its value. */
  private record Subject(String name, List<Term> arguments) {}

  private record Stream(Set<Subject> subjects, ActionDispatcher.Handle performance) {}

  Watch(Formula goal) {
    this.goal = goal;
  }

  /** Whether a running instance of the feature tells of what the goal speaks of. */
  boolean concerns(FeatureType feature, Home home) {
    return feature.continuous()
        && Sensing.names(feature.effect()).stream().anyMatch(watchable(home)::contains);
  }

  /** The step is established and goes on; an earlier one like it is not needed any more. */
  void keep(Step step, ActionDispatcher.Handle performance, Snapshot now, Home home) {
    Map<String, Term> bindings = step.values();
    Set<Subject> subjects = new LinkedHashSet<>();
    collect(step.feature().effect(), bindings, now, home.vocabulary(), subjects);
    Stream before = streams.put(step.key(), new Stream(subjects, performance));
    if (before != null) {
      before.performance().cancel();
    }
  }

  boolean keeps(ActionDispatcher.Handle performance) {
    return streams.values().stream().anyMatch(s -> s.performance() == performance);
  }

  void memberLost(String member) {
    streams.keySet().removeIf(key -> key.member().equals(member));
  }

  void end() {
    List<Stream> ending = new ArrayList<>(streams.values());
    streams.clear();
    ending.forEach(stream -> stream.performance().cancel());
  }

  /** What is known, without what nobody goes on observing though somebody could. */
  Snapshot seen(Snapshot now, Home home) {
    return new WatchedSnapshot(
        now,
        home.vocabulary(),
        watchable(home),
        atom -> isWatched(subject(atom, home.vocabulary())),
        fluent -> isWatched(new Subject(fluent.name(), fluent.arguments())));
  }

  private boolean isWatched(Subject subject) {
    return streams.values().stream().anyMatch(stream -> stream.subjects().contains(subject));
  }

  /** Names on which the goal rests and which a continuous feature of some device senses. */
  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  private Set<String> watchable(Home now) {
    if (now != home) {
      home = now;
      Set<String> sensed = new TreeSet<>();
      now.devices().values().stream()
          .flatMap(device -> device.features().stream())
          .filter(FeatureType::continuous)
          .forEach(feature -> sensed.addAll(Sensing.names(feature.effect())));
      Set<String> names = Symbols.withDerivations(goal, now.vocabulary());
      names.retainAll(sensed);
      watchable = names;
    }
    return watchable;
  }

  private static Subject subject(Formula.Atom atom, Vocabulary vocabulary) {
    boolean functional =
        vocabulary.predicate(atom.predicate()).filter(PredicateDeclaration::functional).isPresent();
    List<Term> arguments = atom.arguments();
    return new Subject(
        atom.predicate(), functional ? arguments.subList(0, arguments.size() - 1) : arguments);
  }

  private static void collect(
      Effect effect,
      Map<String, Term> bindings,
      Snapshot now,
      Vocabulary vocabulary,
      Set<Subject> subjects) {
    Substitution substitution = new Substitution(bindings);
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, bindings, now, vocabulary, subjects));
    } else if (effect instanceof Effect.When when) {
      if (new Evaluation(now).truth(when.condition(), bindings) == Truth.TRUE) {
        collect(when.effect(), bindings, now, vocabulary, subjects);
      }
    } else if (effect instanceof Effect.Forall forall) {
      for (Map<String, Term> each : groundings(forall.variables(), bindings, now)) {
        collect(forall.effect(), each, now, vocabulary, subjects);
      }
    } else if (effect instanceof Effect.SenseAtom sense) {
      subjects.add(subject(substitution.apply(sense.atom()), vocabulary));
    } else if (effect instanceof Effect.SenseNumber sense) {
      Expression.Fluent fluent = substitution.apply(sense.fluent());
      subjects.add(new Subject(fluent.name(), fluent.arguments()));
    }
  }

  private static List<Map<String, Term>> groundings(
      List<TypedVariable> variables, Map<String, Term> bindings, Snapshot now) {
    List<Map<String, Term>> groundings = List.of(bindings);
    for (TypedVariable variable : variables) {
      List<Map<String, Term>> extended = new ArrayList<>();
      for (Map<String, Term> grounding : groundings) {
        for (Term.Name individual : now.individuals(variable.className().orElse(""))) {
          Map<String, Term> with = new HashMap<>(grounding);
          with.put(variable.name(), individual);
          extended.add(with);
        }
      }
      groundings = extended;
    }
    return groundings;
  }
}

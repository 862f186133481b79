package org.maestro.ontology.permission;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Effect;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.Self;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The features of a home's devices by which something directly becomes so. */
final class Ways {
  private final Home home;
  private final Facts facts;
  private final Set<String> changing = new HashSet<>();

  Ways(Home home, Facts facts) {
    this.home = home;
    this.facts = facts;
    features().map(FeatureType::effect).forEach(this::addChanging);
  }

  private Stream<FeatureType> features() {
    return home.devices().values().stream().flatMap(device -> device.features().stream());
  }

  /** Whether nothing that anybody does changes what the formula speaks of. */
  boolean isFixed(Formula formula) {
    Set<String> words = new HashSet<>();
    Leaves.of(formula, atom -> words.add(atom.predicate()), fluent -> words.add(fluent.name()));
    return words.stream().noneMatch(this::mayChange);
  }

  private boolean mayChange(String word) {
    return changing.contains(word)
        || home.vocabulary()
            .predicate(word)
            .filter(
                one ->
                    one.derivedWhen().isPresent()
                        || one.computedBy().isPresent()
                        || one.countedWhen().isPresent())
            .isPresent();
  }

  /** Whether it follows from something else. */
  boolean isDerived(String word) {
    return mayChange(word) && !changing.contains(word);
  }

  /** Those by which the atom comes to hold, or ceases to. */
  List<Way> of(Formula.Atom atom, boolean holding) {
    List<Way> ways = new ArrayList<>();
    forEach(
        (device, feature, effect) -> {
          Optional<Formula.Atom> changed =
              holding
                  ? effect instanceof Effect.Add add ? Optional.of(add.atom()) : Optional.empty()
                  : effect instanceof Effect.Delete delete
                      ? Optional.of(delete.atom())
                      : Optional.empty();
          changed
              .filter(one -> one.predicate().equals(atom.predicate()))
              .flatMap(one -> values(one.arguments(), atom.arguments(), self(device), feature))
              .ifPresent(values -> add(ways, new Way(device, feature, values, "")));
        });
    return ways;
  }

  /** The scripts, with what they take, that plans may use to have the atom hold. */
  List<Run> byScripts(Formula.Atom atom) {
    List<Run> runs = new ArrayList<>();
    for (Script script : home.scripts().values()) {
      script
          .action()
          .ifPresent(
              action ->
                  leaves(action.effect()).stream()
                      .filter(Effect.Add.class::isInstance)
                      .map(effect -> ((Effect.Add) effect).atom())
                      .filter(one -> one.predicate().equals(atom.predicate()))
                      .flatMap(
                          one ->
                              values(one.arguments(), atom.arguments(), Map.of(), action).stream())
                      .forEach(values -> runs.add(new Run(script, arguments(script, values)))));
    }
    return runs;
  }

  /**
   * A script that is run.
   *
   * @param arguments variables where any may do
   */
  record Run(Script script, List<Term> arguments) {}

  private static List<Term> arguments(Script script, Map<String, Term> values) {
    return script.parameters().stream()
        .map(one -> values.getOrDefault(one.name(), new Term.Variable(one.name())))
        .toList();
  }

  /** Those that change the number. */
  List<Way> of(Expression.Fluent fluent) {
    List<Way> ways = new ArrayList<>();
    forEach(
        (device, feature, effect) -> {
          if (effect instanceof Effect.Change change
              && change.fluent().name().equals(fluent.name())) {
            boolean isGiven =
                change.assignment() == Effect.Assignment.ASSIGN
                    && change.value() instanceof Expression.OfTerm given
                    && given.term() instanceof Term.Variable;
            String number =
                isGiven ? ((Term.Variable) ((Expression.OfTerm) change.value()).term()).name() : "";
            values(change.fluent().arguments(), fluent.arguments(), self(device), feature)
                .ifPresent(values -> add(ways, new Way(device, feature, values, number)));
          }
        });
    return ways;
  }

  /** What is so for good and excludes it makes it no way. */
  private void add(List<Way> ways, Way way) {
    Substitution values = new Substitution(way.values());
    Formula needed = values.apply(way.feature().precondition());
    boolean isExcluded =
        (needed instanceof Formula.And and ? and.operands() : List.of(needed))
            .stream()
                .filter(part -> FreeVariables.of(part).isEmpty() && isFixed(part))
                .anyMatch(part -> new Evaluation(facts).truth(part, Map.of()) == Truth.FALSE);
    if (!isExcluded) {
      ways.add(way);
    }
  }

  /** What is done by each part of each feature's effect. */
  private interface Visitor {
    void visit(Device device, FeatureType feature, Effect effect);
  }

  private void forEach(Visitor visitor) {
    home.devices()
        .values()
        .forEach(
            device ->
                device
                    .features()
                    .forEach(
                        feature ->
                            leaves(feature.effect())
                                .forEach(effect -> visitor.visit(device, feature, effect))));
  }

  private static List<Effect> leaves(Effect effect) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().flatMap(part -> leaves(part).stream()).toList();
    } else if (effect instanceof Effect.When when) {
      return leaves(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      return leaves(forall.effect());
    }
    return List.of(effect);
  }

  private void addChanging(Effect effect) {
    for (Effect leaf : leaves(effect)) {
      if (leaf instanceof Effect.Add add) {
        changing.add(add.atom().predicate());
      } else if (leaf instanceof Effect.Delete delete) {
        changing.add(delete.atom().predicate());
      } else if (leaf instanceof Effect.Change change) {
        changing.add(change.fluent().name());
      } else if (leaf instanceof Effect.SenseAtom sense) {
        changing.add(sense.atom().predicate());
      } else if (leaf instanceof Effect.SenseNumber sense) {
        changing.add(sense.fluent().name());
      }
    }
  }

  private static Map<String, Term> self(Device device) {
    return Map.of(Self.VARIABLE.name(), new Term.Name(device.id()));
  }

  /** The values with which the effect speaks of that; empty where it never does. */
  private Optional<Map<String, Term>> values(
      List<Term> effect, List<Term> wanted, Map<String, Term> given, FeatureType feature) {
    Map<String, Term> values = new HashMap<>(given);
    if (effect.size() != wanted.size()) {
      return Optional.empty();
    }
    for (int i = 0; i < effect.size(); i++) {
      Term value = wanted.get(i);
      Term there =
          effect.get(i) instanceof Term.Variable open
              ? values.getOrDefault(open.name(), open)
              : effect.get(i);
      if (there instanceof Term.Variable open && mayBe(value, open.name(), feature)) {
        values.put(open.name(), value);
      } else if (!there.equals(value) && !(value instanceof Term.Variable)) {
        return Optional.empty();
      }
    }
    values.values().removeIf(Term.Variable.class::isInstance);
    return Optional.of(values);
  }

  /** A thing has to be of a class of which the parameter may be. */
  private boolean mayBe(Term value, String parameter, FeatureType feature) {
    if (!(value instanceof Term.Name name) || !home.individuals().containsKey(name.text())) {
      return true;
    }
    Set<String> classes = home.individuals().get(name.text()).classes();
    return Stream.concat(feature.inputs().stream(), feature.binds().stream())
        .filter(one -> one.name().equals(parameter))
        .map(Parameter::types)
        .allMatch(types -> types.isEmpty() || types.stream().anyMatch(classes::contains));
  }
}

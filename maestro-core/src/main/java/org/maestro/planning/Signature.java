package org.maestro.planning;

import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;

/**
 * Which predicates and numbers the offered features may change. All others are static: the facts
 * decide them once. A derived predicate is dynamic when its definition is.
 */
final class Signature {
  private final Vocabulary vocabulary;
  private final Set<String> changed = new HashSet<>();
  private final Map<String, Boolean> dynamicDerived = new HashMap<>();
  private final Map<Formula, Boolean> dynamicFormulas = new IdentityHashMap<>();

  Signature(Vocabulary vocabulary, List<PricedFeature> features) {
    this.vocabulary = vocabulary;
    Set<FeatureType> types = Collections.newSetFromMap(new IdentityHashMap<>());
    for (PricedFeature feature : features) {
      if (types.add(feature.type())) {
        collect(feature.type().effect(), changed);
      }
    }
  }

  /** The names of what an effect may change or find out. */
  static Set<String> changedBy(Effect effect) {
    Set<String> names = new LinkedHashSet<>();
    collect(effect, names);
    return names;
  }

  private static void collect(Effect effect, Set<String> changed) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, changed));
    } else if (effect instanceof Effect.When when) {
      collect(when.effect(), changed);
    } else if (effect instanceof Effect.Forall forall) {
      collect(forall.effect(), changed);
    } else if (effect instanceof Effect.Add add) {
      changed.add(add.atom().predicate());
    } else if (effect instanceof Effect.Delete delete) {
      changed.add(delete.atom().predicate());
    } else if (effect instanceof Effect.SenseAtom sense) {
      changed.add(sense.atom().predicate());
    } else if (effect instanceof Effect.SenseNumber sense) {
      changed.add(sense.fluent().name());
    } else if (effect instanceof Effect.Change change) {
      changed.add(change.fluent().name());
    }
  }

  Optional<PredicateDeclaration> declaration(String predicate) {
    return vocabulary.predicate(predicate);
  }

  /** Whether the last argument is the value of a variable that the others name. */
  boolean isFunctional(Formula.Atom atom) {
    return atom.arguments().size() > 1
        && declaration(atom.predicate()).map(PredicateDeclaration::functional).orElse(false);
  }

  /** The definition of a derived predicate. */
  Optional<Formula> definition(String predicate) {
    return declaration(predicate).flatMap(PredicateDeclaration::derivedWhen);
  }

  boolean isDynamic(String name) {
    Optional<Formula> definition = definition(name);
    if (definition.isEmpty()) {
      return changed.contains(name);
    }
    Boolean known = dynamicDerived.get(name);
    if (known == null) {
      dynamicDerived.put(name, false);
      known = isDynamic(definition.get());
      dynamicDerived.put(name, known);
    }
    return known;
  }

  boolean isDynamic(Formula formula) {
    Boolean known = dynamicFormulas.get(formula);
    if (known == null) {
      known = mayChange(formula);
      dynamicFormulas.put(formula, known);
    }
    return known;
  }

  private boolean mayChange(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      return isDynamic(atom.predicate());
    } else if (formula instanceof Formula.And and) {
      return and.operands().stream().anyMatch(this::isDynamic);
    } else if (formula instanceof Formula.Or or) {
      return or.operands().stream().anyMatch(this::isDynamic);
    } else if (formula instanceof Formula.Not not) {
      return isDynamic(not.operand());
    } else if (formula instanceof Formula.Imply imply) {
      return isDynamic(imply.premise()) || isDynamic(imply.conclusion());
    } else if (formula instanceof Formula.Exists exists) {
      return isDynamic(exists.body());
    } else if (formula instanceof Formula.Forall forall) {
      return isDynamic(forall.body());
    } else if (formula instanceof Formula.Comparison comparison) {
      return isDynamic(comparison.left()) || isDynamic(comparison.right());
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      return isDynamic(unknown.atom().predicate());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      return isDynamic(unknown.fluent().name());
    }
    return isDynamic(((Formula.Keep) formula).body());
  }

  private boolean isDynamic(Expression expression) {
    if (expression instanceof Expression.Fluent fluent) {
      return isDynamic(fluent.name());
    }
    return expression instanceof Expression.Arithmetic arithmetic
        && arithmetic.operands().stream().anyMatch(this::isDynamic);
  }
}

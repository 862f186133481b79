package org.maestro.planning.problem;

import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.PricedFeature;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;

/**
 * The predicates and numbers that the offered features may change. All others are static: the facts
 * decide them once. A derived predicate is dynamic when its definition is.
 */
public final class Signature {
  private final Vocabulary vocabulary;
  private final Set<String> changed = new HashSet<>();
  private final Map<String, Boolean> dynamicDerived = new HashMap<>();
  private final IdentityHashMap<Formula, Boolean> dynamicFormulas = new IdentityHashMap<>();

  public Signature(Vocabulary vocabulary, List<PricedFeature> features) {
    this.vocabulary = vocabulary;
    Set<FeatureType> types = Collections.newSetFromMap(new IdentityHashMap<>());
    for (PricedFeature feature : features) {
      if (types.add(feature.type())) {
        changed.addAll(changedBy(feature.type().effect()));
      }
    }
  }

  /** Whether features may change the same predicates and numbers there. */
  public boolean changesTheSameAs(Signature other) {
    return changed.equals(other.changed);
  }

  /** The names of what an effect may change or find out. */
  public static Set<String> changedBy(Effect effect) {
    Set<String> names = new LinkedHashSet<>();
    forEachPart(
        effect,
        part -> {
          if (part instanceof Effect.Add add) {
            names.add(add.atom().predicate());
          } else if (part instanceof Effect.Delete delete) {
            names.add(delete.atom().predicate());
          } else if (part instanceof Effect.SenseAtom sense) {
            names.add(sense.atom().predicate());
          } else if (part instanceof Effect.SenseNumber sense) {
            names.add(sense.fluent().name());
          } else if (part instanceof Effect.Change change) {
            names.add(change.fluent().name());
          }
        });
    return names;
  }

  /** Predicates that the effect makes true, other than by finding out. */
  public static Set<String> addedBy(Effect effect) {
    Set<String> names = new LinkedHashSet<>();
    forEachPart(
        effect,
        part -> {
          if (part instanceof Effect.Add add) {
            names.add(add.atom().predicate());
          }
        });
    return names;
  }

  /** Predicates that the effect finds out. */
  public static Set<String> sensedBy(Effect effect) {
    Set<String> names = new LinkedHashSet<>();
    forEachPart(
        effect,
        part -> {
          if (part instanceof Effect.SenseAtom sense) {
            names.add(sense.atom().predicate());
          }
        });
    return names;
  }

  /** Predicates that the effect makes untrue, so that they may have to be found out again. */
  public static Set<String> removedBy(Effect effect) {
    Set<String> names = new LinkedHashSet<>();
    forEachPart(
        effect,
        part -> {
          if (part instanceof Effect.Delete delete) {
            names.add(delete.atom().predicate());
          }
        });
    return names;
  }

  private static void forEachPart(Effect effect, Consumer<Effect> consumer) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> forEachPart(part, consumer));
    } else if (effect instanceof Effect.When when) {
      forEachPart(when.effect(), consumer);
    } else if (effect instanceof Effect.Forall forall) {
      forEachPart(forall.effect(), consumer);
    } else {
      consumer.accept(effect);
    }
  }

  public Optional<PredicateDeclaration> declaration(String predicate) {
    return vocabulary.predicate(predicate);
  }

  /** Whether the last argument is the value of a variable that the others name. */
  public boolean isFunctional(Formula.Atom atom) {
    return atom.arguments().size() > 1
        && declaration(atom.predicate()).map(PredicateDeclaration::functional).orElse(false);
  }

  /** The definition of a derived predicate. */
  Optional<Formula> definition(String predicate) {
    return declaration(predicate).flatMap(PredicateDeclaration::derivedWhen);
  }

  public boolean isDynamic(String name) {
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

  public boolean isDynamic(Formula formula) {
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
    } else if (formula instanceof Formula.Comparison comparison) {
      return isDynamic(comparison.left()) || isDynamic(comparison.right());
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      return isDynamic(unknown.atom().predicate());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      return isDynamic(unknown.fluent().name());
    }
    return formula.parts().stream().anyMatch(this::isDynamic);
  }

  private boolean isDynamic(Expression expression) {
    if (expression instanceof Expression.Fluent fluent) {
      return isDynamic(fluent.name());
    }
    return expression instanceof Expression.Arithmetic arithmetic
        && arithmetic.operands().stream().anyMatch(this::isDynamic);
  }
}

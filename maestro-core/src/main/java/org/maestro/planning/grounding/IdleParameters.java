package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.ConditionCompiler;
import org.maestro.planning.problem.EffectCompiler;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.Signature;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/**
 * Parameters of a feature on which its price does not depend, and what they are good for. Where one
 * of their values asks for nothing and does nothing of its own, instances with other values only
 * ask for more: they matter for nothing but the effects that name the parameter, and are made when
 * those are wanted. So that putting a cup down somewhere in a room is one instance, not one for
 * each thing beside which it could be put.
 */
final class IdleParameters {
  private record Parts(List<Formula> conditions, List<Effect> effects) {}

  private final PricedFeature feature;
  private final Signature signature;
  private final ConditionCompiler conditions;
  private final EffectCompiler effects;
  private final Map<String, Parts> partsByParameter = new LinkedHashMap<>();

  IdleParameters(
      PricedFeature feature,
      Signature signature,
      ConditionCompiler conditions,
      EffectCompiler effects) {
    this.feature = feature;
    this.signature = signature;
    this.conditions = conditions;
    this.effects = effects;
    Set<String> priced =
        new LinkedHashSet<>(FreeVariables.of(FeatureTemplate.statedPrice(feature)));
    priced.addAll(FreeVariables.of(feature.type().seconds()));
    for (List<Parameter> parameters : List.of(feature.type().inputs(), feature.type().binds())) {
      for (Parameter parameter : parameters) {
        if (!priced.contains(parameter.name())) {
          partsByParameter.put(parameter.name(), parts(parameter.name()));
        }
      }
    }
  }

  private Parts parts(String parameter) {
    Parts parts = new Parts(new ArrayList<>(), new ArrayList<>());
    collect(feature.type().precondition(), parameter, parts.conditions());
    collect(feature.type().effect(), parameter, parts.effects());
    return parts;
  }

  private static void collect(Formula formula, String parameter, List<Formula> into) {
    if (formula instanceof Formula.And and) {
      and.operands().forEach(operand -> collect(operand, parameter, into));
    } else if (FreeVariables.of(formula).contains(parameter)) {
      into.add(formula);
    }
  }

  private static void collect(Effect effect, String parameter, List<Effect> into) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, parameter, into));
    } else if (FreeVariables.of(effect).contains(parameter)) {
      into.add(effect);
    }
  }

  /** Whether an effect of its own is all that the parameter is for, as far as its name tells. */
  boolean mayBeIdle(String parameter) {
    Parts parts = partsByParameter.get(parameter);
    return parts != null && mayBeIdle(parts, parameter);
  }

  private boolean mayBeIdle(Parts parts, String parameter) {
    return parts.effects().stream()
        .allMatch(effect -> effect instanceof Effect.When && namesAlways(effect, parameter));
  }

  /** Whether all that the effect changes is named by the parameter, so that who wants it asks. */
  private boolean namesAlways(Effect effect, String parameter) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().allMatch(part -> namesAlways(part, parameter));
    } else if (effect instanceof Effect.When when) {
      return namesAlways(when.effect(), parameter);
    } else if (effect instanceof Effect.Forall forall) {
      return namesAlways(forall.effect(), parameter);
    } else if (effect instanceof Effect.Add add) {
      return names(add.atom(), parameter);
    } else if (effect instanceof Effect.Delete delete) {
      return names(delete.atom(), parameter);
    } else if (effect instanceof Effect.SenseAtom sense) {
      return names(sense.atom(), parameter);
    } else if (effect instanceof Effect.SenseNumber sense) {
      return sense.fluent().arguments().contains(new Term.Variable(parameter));
    }
    return ((Effect.Change) effect).fluent().arguments().contains(new Term.Variable(parameter));
  }

  /** The value of a functional predicate is no part of its name. */
  private boolean names(Formula.Atom atom, String parameter) {
    List<Term> arguments = atom.arguments();
    int named = signature.isFunctional(atom) ? arguments.size() - 1 : arguments.size();
    return arguments.subList(0, named).contains(new Term.Variable(parameter));
  }

  /**
   * A value with which the feature asks for nothing and does nothing that it would not with any
   * other, at no higher price; empty when there is none.
   *
   * @param bindings of all other parameters
   */
  Optional<Term> sufficientValue(String parameter, List<Term> domain, Map<String, Term> bindings) {
    Parts parts = partsByParameter.get(parameter);
    if (parts == null || !mayBeIdle(parts, parameter) || domain.size() < 2) {
      return Optional.empty();
    }
    Map<String, Term> tried = new HashMap<>(bindings);
    for (Term value : new LinkedHashSet<>(bindings.values())) {
      if (domain.contains(value)) {
        tried.put(parameter, value);
        if (isSufficient(parts, tried)) {
          return isCheapest(tried) ? Optional.of(value) : Optional.empty();
        }
      }
    }
    return Optional.empty();
  }

  private boolean isSufficient(Parts parts, Map<String, Term> bindings) {
    return parts.conditions().stream()
            .allMatch(c -> conditions.condition(c, bindings) == Condition.Constant.TRUE)
        && parts.effects().stream().allMatch(e -> effects.changes(e, bindings).isEmpty());
  }

  /** A price that the member itself computed may be above what the others cost at least. */
  private boolean isCheapest(Map<String, Term> bindings) {
    Map<String, Term> parameters = new HashMap<>(bindings);
    parameters.remove(Self.NAME);
    PricedFeature.ExactPrice exact = feature.exact().get(parameters);
    return exact == null
        || conditions.number(FeatureTemplate.statedPrice(feature), bindings)
                instanceof NumberExpression.Constant least
            && exact.cost() <= least.number();
  }
}

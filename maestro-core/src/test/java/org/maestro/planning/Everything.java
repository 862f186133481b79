package org.maestro.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Relevance;
import org.maestro.sl.Term;

/** Grounds a task over all parameter values, without asking what matters. */
public final class Everything {
  private Everything() {}

  public static GroundProblem ground(PlanningTask task) {
    Grounder grounder = new Grounder(task);
    List<Operator> operators = new ArrayList<>();
    for (PricedFeature feature : task.features()) {
      List<Parameter> parameters = new ArrayList<>(feature.type().inputs());
      parameters.addAll(feature.type().binds());
      choose(task, grounder, feature, parameters, new LinkedHashMap<>(), operators);
    }
    Relevance everything = new Relevance(target -> List.of());
    everything.closeWithAll(operators, grounder.goal().condition());
    return GroundProblem.complete(everything, grounder.goal());
  }

  private static void choose(
      PlanningTask task,
      Grounder grounder,
      PricedFeature feature,
      List<Parameter> open,
      Map<String, Term> bindings,
      List<Operator> operators) {
    if (open.isEmpty()) {
      operators.addAll(
          grounder.instances(
              new StepKey(feature.member(), feature.type().name(), new LinkedHashMap<>(bindings))));
      return;
    }
    Parameter next = open.get(0);
    Set<Term> values = new LinkedHashSet<>(next.oneOf());
    next.types().forEach(type -> values.addAll(task.facts().individuals(type)));
    for (Term value : values) {
      bindings.put(next.name(), value);
      choose(task, grounder, feature, open.subList(1, open.size()), bindings, operators);
    }
    bindings.remove(next.name());
  }
}

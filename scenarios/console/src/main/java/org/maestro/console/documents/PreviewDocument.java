package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.Sentences;
import org.maestro.ontology.home.Home;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.Step;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;

/** A plan before it is begun. */
public final class PreviewDocument {
  private PreviewDocument() {}

  /**
   * @param home whose words the steps are told in
   */
  public static JsonNode of(Formula goal, PlanningResult result, Home home) {
    JsonMembers document = JsonMembers.empty().text("goal", SlPrinter.print(goal));
    if (result instanceof PlanningResult.Found found) {
      plan(document.text("verdict", "plan"), found.plan(), new Sentences(home.vocabulary()));
      return document.text("reason", Optional.empty()).node();
    }
    document.text("verdict", result instanceof PlanningResult.Impossible ? "none" : "unknown");
    plan(document, new Plan(List.of(), Double.NaN, Map.of()), new Sentences(home.vocabulary()));
    return document.text("reason", reason(result)).node();
  }

  private static void plan(JsonMembers document, Plan plan, Sentences sentences) {
    boolean isPriced = Double.isFinite(plan.cost());
    document
        .number("cost", plan.cost())
        .number("duration_s", isPriced ? plan.seconds() : Double.NaN);
    ArrayNode steps = document.node().putArray("steps");
    for (Step step : plan.steps()) {
      JsonMembers row =
          JsonMembers.in(steps)
              .text("text", sentences.step(step))
              .text("member", step.member())
              .text("feature", step.feature().name())
              .number("cost", step.cost())
              .number("seconds", step.seconds());
      row.node().put("number", step.number());
      step.after().stream().sorted().forEach(row.node().putArray("after")::add);
    }
  }

  private static String reason(PlanningResult result) {
    if (result instanceof PlanningResult.GaveUp gaveUp) {
      return gaveUp.reason();
    }
    return "From what is known and described now there is no plan; when it is stated, it is told who"
        + " or what stands in the way.";
  }
}

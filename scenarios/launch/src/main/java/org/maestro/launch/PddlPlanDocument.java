package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.maestro.console.documents.JsonMembers;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.search.Solution;

/**
 * What a problem in PDDL came to, as one JSON document.
 *
 * @param verdict plan, unsolvable or none found
 * @param proven that it is so: that no plan is cheaper, or that there is none
 * @param cost of the plan; empty without one
 * @param lowerBound no plan costs less; empty without a plan
 * @param reasons why there is no plan
 */
record PddlPlanDocument(
    String domain,
    String problem,
    String verdict,
    boolean proven,
    Optional<BigDecimal> cost,
    Optional<BigDecimal> lowerBound,
    List<Step> steps,
    List<String> reasons) {

  /**
   * One step.
   *
   * @param text as plans are written: {@code (drive truck-1 here there)}
   */
  record Step(String text, BigDecimal cost) {}

  /**
   * @param reasons why there is no plan, when that is proven
   */
  static PddlPlanDocument of(
      PddlSolving.Asked asked, GroundTask task, Solution solution, List<String> reasons) {
    boolean unsolvable = solution.verdict() == Solution.Verdict.UNSOLVABLE;
    if (!solution.hasPlan()) {
      return unsolvable
          ? without(asked, "unsolvable", true, reasons)
          : without(asked, PddlSolving.noPlan(solution));
    }
    return new PddlPlanDocument(
        asked.domain(),
        asked.problem(),
        "plan",
        solution.verdict() == Solution.Verdict.OPTIMAL,
        Optional.of(PddlSolving.amount(solution.cost(), task)),
        Optional.of(PddlSolving.amount(solution.lowerBound(), task)),
        solution.operators().stream()
            .map(
                operator ->
                    new Step(
                        task.names().operator(operator), PddlSolving.amount(operator.cost(), task)))
            .filter(step -> !step.text().isEmpty())
            .toList(),
        reasons);
  }

  /** Neither a plan nor a proof; a sentence says why. */
  static PddlPlanDocument without(PddlSolving.Asked asked, String sentence) {
    return without(asked, "none found", false, List.of(sentence));
  }

  private static PddlPlanDocument without(
      PddlSolving.Asked asked, String verdict, boolean proven, List<String> reasons) {
    return new PddlPlanDocument(
        asked.domain(),
        asked.problem(),
        verdict,
        proven,
        Optional.empty(),
        Optional.empty(),
        List.of(),
        reasons);
  }

  @Override
  public String toString() {
    JsonMembers document =
        JsonMembers.empty()
            .text("domain", domain)
            .text("problem", problem)
            .text("verdict", verdict)
            .truth("proven", proven);
    document.node().put("cost", cost.orElse(null)).put("lower_bound", lowerBound.orElse(null));
    ArrayNode array = document.node().putArray("steps");
    for (Step step : steps) {
      List<String> words = Arrays.asList(step.text().replaceAll("[()]", "").split(" "));
      JsonMembers members = JsonMembers.in(array);
      members.node().put("number", array.size());
      members
          .text("action", words.get(0))
          .words("arguments", words.subList(1, words.size()))
          .node()
          .put("cost", step.cost());
    }
    return document.words("reasons", reasons).toString();
  }
}

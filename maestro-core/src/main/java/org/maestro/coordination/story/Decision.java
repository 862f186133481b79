package org.maestro.coordination.story;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.Sentences;
import org.maestro.ontology.home.Home;
import org.maestro.planning.api.Choice;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.explanation.ChoiceSearch;

/**
 * A plan that was adopted, with all that it was chosen from.
 *
 * @param questions exact prices asked
 */
public record Decision(PlanningTask task, Plan plan, List<Proposal> bids, int questions) {
  private static final long BYTES = 4_096;
  private static final long BYTES_OF_A_PRICE = 768;
  private static final long BYTES_OF_A_REASON = 256;

  /** What it takes of memory, about; facts are shared with what is known now. */
  long bytes() {
    long prices =
        task.features().stream().mapToLong(feature -> 1 + feature.exact().size()).sum()
            + bids.stream().mapToLong(bid -> bid.prices().size()).sum();
    long reasons = (long) bids.size() + task.whyBarred().size() + task.unavailable().size();
    return BYTES
        + BYTES_OF_A_PRICE * (prices + plan.steps().size())
        + BYTES_OF_A_REASON * (reasons + task.barred().size());
  }

  /** The step of that number. */
  public Optional<Step> step(int number) {
    return plan.steps().stream().filter(step -> step.number() == number).findFirst();
  }

  /** Why this step's member and not another; takes as long as some plans do. */
  public Choice choice(Planner planner, Step step) {
    return new ChoiceSearch(planner).of(task, plan, step);
  }

  /** The choice in sentences: the price with others, who refused, who was not asked. */
  public List<String> sentences(Choice choice, Home home) {
    List<String> told = new ArrayList<>();
    Sentences sentences = new Sentences(home.vocabulary());
    told.add(
        "Step %d: %s. It costs %s of %s for the whole plan; exact prices asked: %d."
            .formatted(
                choice.step().number(),
                sentences.step(choice.step()),
                Sentences.number(choice.step().cost()),
                Sentences.number(choice.cost()),
                questions));
    ObstacleSentences obstacles = new ObstacleSentences(home, task.facts());
    for (Choice.Other other : choice.others()) {
      told.add(sentence(other, obstacles));
    }
    if (choice.others().isEmpty()) {
      told.add("Nobody else that was asked could take part in it.");
    }
    for (Proposal bid : bids) {
      bid.refusal()
          .ifPresent(
              reason ->
                  told.add(bid.member() + " refused: " + Sentences.withoutFullStop(reason) + "."));
    }
    task.whyBarred()
        .forEach(
            (key, reason) ->
                told.add(
                    key.member()
                        + ", "
                        + key.feature()
                        + ": "
                        + Sentences.withoutFullStop(reason)
                        + "."));
    Map<String, String> absent = new LinkedHashMap<>();
    task.unavailable().forEach(m -> absent.put(m.feature().member(), m.reason()));
    bids.forEach(bid -> absent.remove(bid.member()));
    absent.forEach(
        (member, reason) ->
            told.add(member + " was not asked: " + Sentences.withoutFullStop(reason) + "."));
    return told;
  }

  private static String sentence(Choice.Other other, ObstacleSentences obstacles) {
    if (other.more().isPresent()) {
      return "With %s instead the plan would cost %s%s more."
          .formatted(
              other.member(),
              other.atLeast() ? "at least " : "",
              Sentences.number(other.more().getAsDouble()));
    }
    return "With %s instead there is no plan. %s"
        .formatted(
            other.member(),
            String.join(" ", other.because().stream().map(obstacles::obstacle).toList()));
  }
}

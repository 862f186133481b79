package org.maestro.console.documents;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.maestro.agents.content.Words;
import org.maestro.sl.Term;

/**
 * The plans that were made for a goal, oldest first, or the steps of the script that it is; and
 * what has become of the steps.
 */
public final class PlansDocument {
  private PlansDocument() {}

  /**
   * @param lines a plan or a step of the script each, as the coordinator tells of them
   */
  public static ObjectNode of(String goal, List<Words> lines) {
    JsonMembers document = JsonMembers.empty().text("goal", goal);
    ArrayNode plans = document.node().putArray("plans");
    ArrayNode script = document.node().putArray("script");
    for (Words line : lines) {
      if (line.find("path").isPresent()) {
        addStepOfScript(script, line);
      } else {
        add(plans, line);
      }
    }
    return document.node();
  }

  private static void add(ArrayNode plans, Words words) {
    JsonMembers plan = JsonMembers.in(plans);
    plan.node().put("number", whole(words, "plan"));
    plan.text("cause", words.string("cause"))
        .number("asked_s", words, "asked")
        .number("made_s", words, "made")
        .text("purpose", words.string("purpose"))
        .number("cost", words, "cost")
        .number("duration_s", words, "lasts");
    plan.node().put("not_asked", whole(words, "notAsked"));
    ArrayNode steps = plan.node().putArray("steps");
    words.find("steps").ifPresent(all -> all.all().forEach(step -> addStep(steps, Words.of(step))));
  }

  private static void addStep(ArrayNode steps, Words words) {
    JsonMembers step = JsonMembers.in(steps);
    step.node().put("number", whole(words, "number"));
    step.text("text", words.string("text"))
        .text("member", words.string("member"))
        .text("feature", words.string("feature"));
    ArrayNode after = step.node().putArray("after");
    words.find("after").map(Words::terms).orElse(List.of()).stream()
        .filter(Term.Number.class::isInstance)
        .map(Term.Number.class::cast)
        .forEach(number -> after.add((int) number.value()));
    step.number("cost", words, "cost")
        .number("duration_s", words, "seconds")
        .number("start_s", words, "start");
    became(step, words);
  }

  private static void addStepOfScript(ArrayNode steps, Words words) {
    JsonMembers step =
        JsonMembers.in(steps).text("path", words.string("path")).text("text", words.string("text"));
    step.node().put("depth", whole(words, "depth"));
    became(step, words);
  }

  private static void became(JsonMembers step, Words words) {
    step.text("state", words.string("state"))
        .number("begun_s", words, "begun")
        .number("ended_s", words, "ended")
        .text("problem", words.string("problem"));
  }

  private static int whole(Words words, String name) {
    return (int) words.number(name, 0);
  }
}

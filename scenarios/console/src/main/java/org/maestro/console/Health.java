package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import io.javalin.http.Context;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.maestro.agents.pulse.Condition;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.questions.Questions;

/**
 * The health of a platform, for those who watch over processes (ADE, status derived from
 * heartbeats; A34): {@code /health} tells how its containers do as soon as the process can tell
 * anything, {@code /ready} whether goals are taken now.
 */
final class Health {
  private final Questions questions;
  private final Supplier<SortedMap<String, Condition>> containers;
  private final Supplier<List<String>> impediments;

  /**
   * @param containers of the platform, and whether they give signs of life
   * @param impediments why goals cannot be taken on or pursued now
   */
  Health(
      Questions questions,
      Supplier<SortedMap<String, Condition>> containers,
      Supplier<List<String>> impediments) {
    this.questions = questions;
    this.containers = containers;
    this.impediments = impediments;
  }

  /** How the platform does now, as far as this process has seen. */
  JsonNode document() {
    SortedMap<String, Condition> now = containers.get();
    List<String> reasons = impediments.get();
    boolean well = reasons.isEmpty() && now.values().stream().allMatch(Condition.ALIVE::equals);
    JsonMembers document =
        JsonMembers.empty().text("status", well ? "well" : "impaired").words("reasons", reasons);
    ArrayNode array = document.node().putArray("containers");
    now.forEach(
        (name, condition) ->
            JsonMembers.in(array)
                .text("container", name)
                .text("condition", condition.name().toLowerCase(Locale.ROOT)));
    return document.node();
  }

  /**
   * Always answered with 200: whether something is amiss stands in the answer.
   *
   * @param inFull what it is, too
   */
  void tellHealth(Context context, boolean inFull) {
    JsonNode whole = document();
    answer(
        context,
        200,
        inFull ? whole : JsonMembers.empty().text("status", whole.path("status").asText()).node());
  }

  /**
   * Answered with 200 when goals are taken, and with 503 and the reason when not.
   *
   * @param inFull with the reason
   */
  CompletableFuture<?> tellReadiness(Context context, boolean inFull) {
    return questions
        .goals()
        .handle(
            (goals, failure) -> {
              List<String> reasons = new ArrayList<>(impediments.get());
              if (failure != null) {
                reasons.add(0, Problems.sentence(failure));
              }
              boolean ready = reasons.isEmpty();
              answer(
                  context,
                  ready ? 200 : Problems.OUTSIDE,
                  JsonMembers.empty()
                      .truth("ready", ready)
                      .words("reasons", inFull ? reasons : List.of())
                      .node());
              return null;
            });
  }

  private static void answer(Context context, int status, JsonNode document) {
    context.status(status).contentType("application/json").result(document.toString());
  }
}

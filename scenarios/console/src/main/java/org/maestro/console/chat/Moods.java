package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.api.Operation;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.coordination.api.Mood;

/** The moods that agents show now, the latest of each. Any thread may use it. */
public final class Moods {
  private final Map<String, Mood> moodByAgent = new TreeMap<>();

  public Operation operation() {
    return Operation.get(
        "/moods",
        "moods",
        "The mood that each agent shows now, where a script has had it show one.",
        "moods",
        request -> CompletableFuture.completedFuture(document()));
  }

  /** An agent shows another mood. */
  public synchronized void show(String agent, Mood mood) {
    moodByAgent.put(agent, mood);
  }

  private synchronized JsonNode document() {
    JsonMembers document = JsonMembers.empty();
    ArrayNode moods = document.node().putArray("moods");
    moodByAgent.forEach(
        (agent, mood) -> {
          JsonMembers row = JsonMembers.in(moods).text("agent", agent);
          row.node()
              .put("word", ShownText.of(mood.word()))
              .put("intensity", mood.intensity())
              .put("goal", mood.goalId());
        });
    return document.node();
  }
}

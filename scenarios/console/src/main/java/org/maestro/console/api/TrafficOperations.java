package org.maestro.console.api;

import static org.maestro.console.api.Operation.get;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.api.Operation.Parameter;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.trace.Traces;
import org.maestro.console.traffic.BusTraffic;
import org.maestro.console.traffic.MailTraffic;

/**
 * The operations that tell what goes over the bus and between agents, and what of it was for a
 * goal.
 */
public final class TrafficOperations {
  private TrafficOperations() {}

  public static List<Operation> of(BusTraffic bus, MailTraffic mail, Traces traces) {
    return List.of(
        get(
            "/bus",
            "bus",
            "The latest messages of the bus, oldest first, each with what is wrong with it.",
            "bus",
            request -> CompletableFuture.completedFuture(bus.all())),
        get(
                "/bus/{number}",
                "busMessage",
                "A message of the bus with all of its payload.",
                "bus-message",
                request ->
                    found(
                        number(request.parameter("number")).flatMap(bus::message),
                        "There is no message "
                            + request.parameter("number")
                            + " of the bus, or not any more; the latest thousand are kept."))
            .with(Parameter.path("number", "The number of a message.")),
        get(
            "/conversations",
            "conversations",
            "The latest conversations between agents, the one begun first in front.",
            "conversations",
            request -> CompletableFuture.completedFuture(mail.all())),
        get(
                "/conversations/{conversation}",
                "conversation",
                "A conversation between agents with its messages, oldest first.",
                "conversation",
                request ->
                    found(
                        mail.conversation(request.parameter("conversation")),
                        "There is no conversation "
                            + request.parameter("conversation")
                            + ", or not any more; GET /conversations lists those there are."))
            .with(Parameter.path("conversation", "A conversation's id, such as C1.")),
        get(
                "/goals/{goal}/trace",
                "trace",
                "What was said for a goal in its story, between agents and on the bus.",
                "trace",
                request ->
                    found(
                        traces.trace(request.parameter("goal")),
                        "There is no trace of "
                            + request.parameter("goal")
                            + ", or not any more; those of the latest hundred goals since the platform's start are kept."))
            .with(Parameter.path("goal", "A goal's id, such as G1.")));
  }

  private static Optional<Long> number(String text) {
    return text.matches("\\d{1,18}") ? Optional.of(Long.valueOf(text)) : Optional.empty();
  }

  private static CompletableFuture<JsonNode> found(Optional<JsonNode> document, String otherwise) {
    return document
        .map(CompletableFuture::completedFuture)
        .orElseGet(() -> CompletableFuture.failedFuture(RefusalException.badInput(otherwise)));
  }
}

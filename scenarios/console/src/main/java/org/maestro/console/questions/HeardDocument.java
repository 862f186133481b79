package org.maestro.console.questions;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.OverheardReply;
import org.maestro.agents.content.SaidReply;
import org.maestro.console.documents.JsonMembers;

/** The document of what comes of words as they are heard. */
final class HeardDocument {
  private static final double MILLIS_PER_SECOND = 1_000;

  private HeardDocument() {}

  /**
   * @param at when it was answered
   */
  static JsonNode of(Duration at, OverheardReply reply) {
    JsonMembers document = begun(at, reply).words("goals", List.of());
    reply.refusal().ifPresent(reason -> document.text("refused", reason));
    return document.node();
  }

  /** The same of a whole sentence. */
  static JsonNode of(Duration at, SaidReply reply) {
    boolean isUnderstood = reply instanceof SaidReply.TakenOn;
    JsonMembers document =
        begun(
            at,
            new OverheardReply(List.of(), isUnderstood, List.of(), List.of(), Optional.empty()));
    if (reply instanceof SaidReply.TakenOn taken) {
      return document.words("goals", taken.goals()).text("means", taken.means()).node();
    }
    document.words("goals", List.of());
    if (reply instanceof SaidReply.Replied replied) {
      document.text("reply", replied.text());
      if (!replied.means().isEmpty()) {
        document.text("means", replied.means());
      }
    } else if (reply instanceof SaidReply.Asked asked) {
      document.text("asks", asked.question());
    } else if (reply instanceof SaidReply.Refused refused) {
      document.text("refused", refused.why());
    }
    return document.node();
  }

  private static JsonMembers begun(Duration at, OverheardReply reply) {
    return JsonMembers.empty()
        .number("at_s", at.toMillis() / MILLIS_PER_SECOND)
        .words("looks", reply.looks())
        .truth("nods", reply.nods())
        .words("begun", reply.begun())
        .words("undone", reply.undone());
  }
}

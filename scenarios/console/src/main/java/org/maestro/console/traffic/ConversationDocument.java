package org.maestro.console.traffic;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.OptionalInt;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.text.VisibleText;

/** The documents of conversations; agents of the own platform go by their local names. */
final class ConversationDocument {
  private static final int MOST_OF_SUBJECT = 400;

  private final String own;

  ConversationDocument(String platform) {
    this.own = "@" + platform;
  }

  /** What it is about, who takes part, and how it stands. */
  ObjectNode summary(Conversation conversation) {
    JsonMembers row =
        JsonMembers.empty()
            .text("id", conversation.id())
            .text("conversation", conversation.first().conversation().map(VisibleText::line))
            .text("protocol", conversation.protocol().map(VisibleText::line))
            .text("state", conversation.state().name().toLowerCase(Locale.ROOT))
            .text("subject", ShownText.cut(shown(conversation.first().content()), MOST_OF_SUBJECT))
            .words("participants", conversation.participants().stream().map(this::named).toList())
            .number("messages", OptionalInt.of(conversation.messages().size()));
    ObjectNode said = row.node().putObject("performatives");
    conversation.performatives().forEach(said::put);
    Mail latest = conversation.latest();
    row.text("at", latest.at().toString()).number("at_s", seconds(latest));
    row.node()
        .put("latest", conversation.messages().get(conversation.messages().size() - 1).number());
    return row.node();
  }

  /** The same with its messages. */
  ObjectNode full(Conversation conversation) {
    ObjectNode document = summary(conversation);
    ArrayNode messages = document.putArray("sequence");
    for (Ring.Kept<Mail> kept : conversation.messages()) {
      Mail mail = kept.what();
      JsonMembers row =
          JsonMembers.in(messages)
              .text("performative", mail.message().performative())
              .text("from", named(mail.message().sender()))
              .text("to", named(mail.message().receiver()));
      row.node().put("content", shown(mail.message().content()));
      row.number("characters", OptionalInt.of(mail.characters()))
          .truth("shortened", mail.characters() > mail.message().content().length())
          .text("at", mail.at().toString())
          .number("at_s", seconds(mail));
      row.node().put("number", kept.number());
    }
    return document;
  }

  private static double seconds(Mail mail) {
    return mail.since().toMillis() / 1000.0;
  }

  private static String shown(String content) {
    return ShownText.of(content);
  }

  private String named(String agent) {
    return VisibleText.line(
        agent.endsWith(own) ? agent.substring(0, agent.length() - own.length()) : agent);
  }
}

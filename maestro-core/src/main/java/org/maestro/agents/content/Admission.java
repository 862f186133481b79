package org.maestro.agents.content;

import jade.lang.acl.ACLMessage;
import java.util.Optional;

/** The check whether a message is one that an agent of MAESTRO can read at all. */
public final class Admission {
  /** Far more than any device's description has; JADE itself knows no bound. */
  static final int MOST_CHARACTERS = 256 * 1024;

  private Admission() {}

  /** One sentence that says what is wrong and what to do; empty when nothing is. */
  public static Optional<String> objection(ACLMessage message) {
    if (differs(message.getLanguage(), Words.LANGUAGE)) {
      return Optional.of(
          "The content language %s is not known here; write MAESTRO-SL and name it in the language slot."
              .formatted(Replies.shortened(message.getLanguage())));
    }
    if (differs(message.getOntology(), Words.ONTOLOGY)) {
      return Optional.of(
          "The ontology %s is not known here; it is %s."
              .formatted(Replies.shortened(message.getOntology()), Words.ONTOLOGY));
    }
    if (differs(message.getEncoding(), "UTF-8") && differs(message.getEncoding(), "US-ASCII")) {
      return Optional.of(
          "The encoding %s is not known here; leave the encoding slot out."
              .formatted(Replies.shortened(message.getEncoding())));
    }
    if (message.hasByteSequenceContent()) {
      return Optional.of("The content is a sequence of bytes; send MAESTRO-SL as a string.");
    }
    String content = message.getContent();
    if (content == null || content.isBlank()) {
      return Optional.of("The message has no content; write MAESTRO-SL into the content slot.");
    }
    if (content.length() > MOST_CHARACTERS) {
      return Optional.of(
          "The content has %d characters; more than %d are not read."
              .formatted(content.length(), MOST_CHARACTERS));
    }
    return Optional.empty();
  }

  /** A slot left out says nothing against a message; people leave out much. */
  private static boolean differs(String slot, String expected) {
    return slot != null && !slot.isBlank() && !slot.strip().equalsIgnoreCase(expected);
  }
}

package org.maestro.agents.content;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.math.BigDecimal;
import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.SlSyntaxException;

/** Properties that all replies have in common, whoever sent them. */
public final class Replies {
  private static final int MOST_CHARACTERS = 160;
  private static final String PLATFORM_PREFIX = "ams@";

  private Replies() {}

  /** From the agent management system, which answers for agents that are no more. */
  public static boolean isFromPlatform(ACLMessage message) {
    AID sender = message.getSender();
    return sender != null
        && sender.getName() != null
        && sender.getName().startsWith(PLATFORM_PREFIX);
  }

  /** The reason or problem that a reply names, if it can be read and names one. */
  public static Optional<String> reason(ACLMessage reply) {
    try {
      return Words.parse(reply.getContent()).stream()
          .map(Words::of)
          .flatMap(w -> w.string("problem").or(() -> w.string("reason")).stream())
          .findFirst();
    } catch (SlSyntaxException e) {
      return Optional.empty();
    }
  }

  public static String sender(ACLMessage message) {
    AID sender = message.getSender();
    return sender == null || sender.getName() == null
        ? "somebody without a name"
        : shortened(sender.getLocalName());
  }

  public static String seconds(Duration duration) {
    return BigDecimal.valueOf(duration.toMillis(), 3).stripTrailingZeros().toPlainString() + " s";
  }

  /** Others may write at any length; sentences stay sentences. */
  public static String shortened(String text) {
    String line = text.strip().replaceAll("\\s+", " ");
    return line.length() <= MOST_CHARACTERS ? line : line.substring(0, MOST_CHARACTERS) + "...";
  }
}

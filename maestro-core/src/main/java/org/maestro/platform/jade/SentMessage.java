package org.maestro.platform.jade;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * A message from one agent to another, as FIPA-ACL has it; to several agents it is several.
 *
 * @param performative in small letters, such as {@code accept-proposal}
 * @param sender its whole name, with its platform
 * @param receiver the same
 */
public record SentMessage(
    String performative,
    String sender,
    String receiver,
    Optional<String> conversation,
    Optional<String> protocol,
    String content) {
  /** Of a registration; who looks on is not told it. */
  private static final Pattern PASSWORD =
      Pattern.compile("\\(:password \"(?:[^\"\\\\]|\\\\.)*\"\\)");

  static SentMessage of(AID sender, ACLMessage message, AID receiver) {
    return new SentMessage(
        ACLMessage.getPerformative(message.getPerformative()).toLowerCase(Locale.ROOT),
        sender.getName(),
        receiver.getName(),
        Optional.ofNullable(message.getConversationId()),
        Optional.ofNullable(message.getProtocol()),
        withoutPassword(Objects.requireNonNullElse(message.getContent(), "")));
  }

  private static String withoutPassword(String content) {
    return content.contains(":password")
        ? PASSWORD.matcher(content).replaceAll("(:password \"...\")")
        : content;
  }

  /** The same with another content. */
  public SentMessage withContent(String other) {
    return new SentMessage(performative, sender, receiver, conversation, protocol, other);
  }
}

package org.maestro.agents.negotiation;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SpeechWords;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Messenger;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The way to people by the desk, and to agents by their names. An agent has taken a message when it
 * has agreed or answered; one that is only informed, when it has not protested for a second. Agent
 * thread only.
 */
public final class AclMessenger implements Messenger {

  private static final Logger LOG = LoggerFactory.getLogger(AclMessenger.class);

  /** Under which a message says which part of a script sends it. */
  public static final String PART = "X-maestro-part";

  private static final Duration PROTEST = Duration.ofSeconds(1);

  /** Who has agreed to something may take any time for it. */
  private static final Duration NO_END = Duration.ofDays(365);

  private final MaestroAgent agent;

  public AclMessenger(MaestroAgent agent) {
    this.agent = agent;
  }

  @Override
  public void say(Speech speech, Consumer<Optional<String>> then) {
    send(
        speech.part(),
        AgentNames.DESK,
        SpeechWords.content(speech),
        agent.patience().agreement(),
        reply ->
            then.accept(
                problem(reply)
                    .map(
                        reason ->
                            "%s could not be told anything: %s".formatted(speech.to(), reason))));
  }

  @Override
  public void show(Mood mood, Consumer<Optional<String>> then) {
    send(
        mood.part(),
        AgentNames.DESK,
        SpeechWords.content(mood),
        agent.patience().agreement(),
        reply ->
            then.accept(problem(reply).map(reason -> "Nobody could be shown that: " + reason)));
  }

  @Override
  public void tell(String part, String receiver, Content message, Consumer<Optional<String>> then) {
    boolean isNews = performative(message) == ACLMessage.INFORM;
    send(
        part,
        receiver,
        message,
        isNews ? PROTEST : agent.patience().agreement(),
        reply ->
            then.accept(
                isNews && Conversations.isOverdue(reply)
                    ? Optional.empty()
                    : problem(reply)
                        .map(reason -> "%s has not taken it: %s".formatted(receiver, reason))));
  }

  /** The desk confirms what is kept, as it does what is said. */
  @Override
  public void keep(GivenAnswer answer, Runnable then) {
    send(
        answer.part(),
        AgentNames.DESK,
        SpeechWords.given(answer),
        agent.patience().agreement(),
        reply -> {
          problem(reply)
              .ifPresent(
                  reason -> LOG.warn("The answer to {} is not kept: {}", answer.part(), reason));
          then.run();
        });
  }

  private void send(
      String part,
      String receiver,
      Content message,
      Duration patience,
      Consumer<ACLMessage> answered) {
    ACLMessage letter = agent.message(performative(message), agent.getAID(receiver), message);
    letter.addUserDefinedParameter(PART, part);
    new FirstAnswer(letter, patience, answered);
  }

  private static int performative(Content message) {
    return switch (message.operator()) {
      case "inform" -> ACLMessage.INFORM;
      case "query-ref" -> ACLMessage.QUERY_REF;
      case "query-if" -> ACLMessage.QUERY_IF;
      case "subscribe" -> ACLMessage.SUBSCRIBE;
      default -> ACLMessage.REQUEST;
    };
  }

  private static Optional<String> problem(ACLMessage reply) {
    if (Replies.isFromPlatform(reply)) {
      return Optional.of("there is no such agent; ./maestro agents lists those there are.");
    }
    return switch (reply.getPerformative()) {
      case ACLMessage.REFUSE, ACLMessage.FAILURE, ACLMessage.NOT_UNDERSTOOD ->
          Optional.of(Replies.reason(reply).orElse("it gives no reason."));
      default -> Optional.empty();
    };
  }

  /** What comes after the first answer is nobody's concern here, and no news of its own. */
  private final class FirstAnswer {
    private final String conversation;
    private boolean isThere;

    FirstAnswer(ACLMessage letter, Duration patience, Consumer<ACLMessage> answered) {
      conversation =
          agent
              .conversations()
              .ask(letter, agent.patience(patience), reply -> first(reply, answered));
    }

    private void first(ACLMessage reply, Consumer<ACLMessage> answered) {
      if (!isThere) {
        isThere = true;
        if (!Conversations.isFinal(reply)) {
          agent.conversations().extend(conversation, NO_END);
        }
        answered.accept(reply);
      }
    }
  }
}

package org.maestro.agents.device;

import jade.lang.acl.ACLMessage;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.agents.content.BidReader;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.Once;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets messages through to the members of a generic agent that they mean, if they are of the right
 * kind and whoever sent them may ask; says why not to the others. Agent thread only.
 */
public final class Doorkeeper {
  private static final Logger LOG = LoggerFactory.getLogger(Doorkeeper.class);

  private final MaestroAgent agent;
  private final Map<String, Voice> voices;
  private final Once objections = new Once();

  /**
   * @param voices of the members, by id
   */
  public Doorkeeper(MaestroAgent agent, Map<String, Voice> voices) {
    this.agent = agent;
    this.voices = voices;
  }

  /** The member of which a message speaks, or the only one. */
  public Optional<Voice> voice(Words words) {
    Optional<String> named = words.string("member");
    if (named.isPresent()) {
      return named.map(voices::get);
    }
    return voices.size() == 1
        ? voices.values().stream().findFirst()
        : Optional.ofNullable(voices.get(agent.getLocalName()));
  }

  /** A device must not move because of a message that does not order it to. */
  public void when(ACLMessage message, int performative, Runnable deed) {
    if (message.getPerformative() == performative) {
      deed.run();
    } else {
      agent.refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "This is understood in a %s only, and this message is a %s."
              .formatted(
                  ACLMessage.getPerformative(performative).toLowerCase(),
                  BidReader.performative(message)));
    }
  }

  /** Only who may ask for the feature is answered (A28). */
  public void allowed(ACLMessage message, Words words, Consumer<Voice> deed) {
    objection(message, words, words.string("feature").orElse(""))
        .ifPresentOrElse(
            reason -> agent.refuse(message, ACLMessage.REFUSE, reason),
            () -> asked(message, words, deed));
  }

  /** Why who asks may not ask for the feature. */
  public Optional<String> objection(ACLMessage message, Words words, String feature) {
    Optional<String> objection =
        voice(words).flatMap(voice -> voice.objection(message, words, feature));
    objection
        .filter(objections::isNew)
        .ifPresent(reason -> LOG.warn("{} refuses: {}", agent.getLocalName(), reason));
    return objection;
  }

  private void asked(ACLMessage message, Words words, Consumer<Voice> deed) {
    voice(words)
        .ifPresentOrElse(
            deed,
            () ->
                agent.refuse(
                    message,
                    ACLMessage.REFUSE,
                    "%s stands for %s; say which one is meant, such as (:member %s)."
                        .formatted(
                            agent.getLocalName(),
                            String.join(", ", voices.keySet()),
                            voices.keySet().stream().findFirst().orElse(""))));
  }
}

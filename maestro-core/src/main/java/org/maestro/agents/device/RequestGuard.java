package org.maestro.agents.device;

import jade.lang.acl.ACLMessage;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.agents.content.ProposalReader;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.Once;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets messages through to the members of a generic agent that they mean, if they are of the right
 * kind and whoever sent them may ask; says why not to the others. Agent thread only.
 */
public final class RequestGuard {
  private static final Logger LOG = LoggerFactory.getLogger(RequestGuard.class);

  private final MaestroAgent agent;
  private final Map<String, MemberProxy> proxies;
  private final Once objections = new Once();

  /**
   * @param proxies of the members, by id
   */
  public RequestGuard(MaestroAgent agent, Map<String, MemberProxy> proxies) {
    this.agent = agent;
    this.proxies = proxies;
  }

  /** The member of which a message speaks, or the only one. */
  public Optional<MemberProxy> proxy(Words words) {
    Optional<String> named = words.string("member");
    if (named.isPresent()) {
      return named.map(proxies::get);
    }
    return proxies.size() == 1
        ? proxies.values().stream().findFirst()
        : Optional.ofNullable(proxies.get(agent.getLocalName()));
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
                  ACLMessage.getPerformative(performative).toLowerCase(Locale.ROOT),
                  ProposalReader.performative(message)));
    }
  }

  /** Only who may ask for the feature is answered (ADE, 3.1; A28). */
  public void allowed(ACLMessage message, Words words, Consumer<MemberProxy> deed) {
    objection(message, words, words.string("feature").orElse(""))
        .ifPresentOrElse(
            reason -> agent.refuse(message, ACLMessage.REFUSE, reason),
            () -> asked(message, words, deed));
  }

  /** Only who may have components used stands in the queue for them. */
  public void mayUse(ACLMessage message, Words words, Consumer<MemberProxy> deed) {
    Set<String> components = Set.copyOf(words.strings("components"));
    proxy(words)
        .flatMap(proxy -> proxy.objectionToUse(message, words, components))
        .ifPresentOrElse(
            reason -> agent.refuse(message, ACLMessage.REFUSE, reason),
            () -> asked(message, words, deed));
  }

  /** Why who asks may not ask for the feature. */
  public Optional<String> objection(ACLMessage message, Words words, String feature) {
    Optional<String> objection =
        proxy(words).flatMap(proxy -> proxy.objection(message, words, feature));
    objection
        .filter(objections::isNew)
        .ifPresent(reason -> LOG.warn("{} refuses: {}", agent.getLocalName(), reason));
    return objection;
  }

  /** The member of which the message speaks answers whoever asks. */
  public void asked(ACLMessage message, Words words, Consumer<MemberProxy> deed) {
    proxy(words)
        .ifPresentOrElse(
            deed,
            () ->
                agent.refuse(
                    message,
                    ACLMessage.REFUSE,
                    "%s stands for %s; say which one is meant, such as (:member %s)."
                        .formatted(
                            agent.getLocalName(),
                            String.join(", ", proxies.keySet()),
                            proxies.keySet().stream().findFirst().orElse(""))));
  }
}

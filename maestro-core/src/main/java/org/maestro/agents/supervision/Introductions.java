package org.maestro.agents.supervision;

import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.FIPAManagementVocabulary;
import jade.domain.FIPAAgentManagement.Property;
import jade.domain.FIPAAgentManagement.SearchConstraints;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPAException;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.references.References;
import org.maestro.agents.references.Wanted;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.ontology.home.AccessList;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The registry's part in references (ADE, 3.1; A25), as {@link References} has them: whoever wants
 * one asks here, and if the home lets him, the request is passed on to the agent that is meant,
 * which answers him itself. Agent thread only.
 */
public final class Introductions {
  private static final Logger LOG = LoggerFactory.getLogger(Introductions.class);
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);

  private final MaestroAgent supervisor;
  private final Containers containers;

  /** Somebody who offers what is wanted. */
  private record Offer(String agent, String member) {}

  public Introductions(MaestroAgent supervisor, Containers containers) {
    this.supervisor = supervisor;
    this.containers = containers;
  }

  /** Who asks is told to whom his request was passed on, or why it was not. */
  public void refer(ACLMessage message, Words words) {
    Wanted wanted = Wanted.read(words);
    Caller asker = Caller.of(message);
    boolean isRecruiting =
        FIPANames.InteractionProtocol.FIPA_RECRUITING.equals(message.getProtocol());
    if (message.getPerformative() != ACLMessage.PROXY
        || !isRecruiting
        || message.getConversationId() == null
        || wanted.agent().isEmpty() && wanted.feature().isEmpty()) {
      supervisor.refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "A reference is asked for by a proxy message of the protocol fipa-recruiting in a"
              + " conversation, such as (refer (:agent lamp-1)) or (refer (:feature find)).");
    } else if (!access().knows(asker.names())) {
      refuse(
          message,
          "No maestro:Permission of the home lets %s ask anybody for anything."
              .formatted(String.join(" or ", asker.names())));
    } else if (wanted.agent().isPresent()) {
      named(message, asker, wanted.agent().get(), wanted.feature());
    } else {
      offered(message, asker, wanted.feature().get());
    }
  }

  private void named(ACLMessage message, Caller asker, String agent, Optional<String> feature) {
    if (!containers.isThere(agent)) {
      refuse(
          message,
          "There is no agent %s; ./maestro agents lists those there are."
              .formatted(Replies.shortened(agent)));
      return;
    }
    objection(asker, agent, feature)
        .ifPresentOrElse(reason -> refuse(message, reason), () -> passOn(message, asker, agent));
  }

  /** The yellow pages are asked first. */
  private void offered(ACLMessage message, Caller asker, String feature) {
    ServiceDescription service = new ServiceDescription();
    service.setType(feature);
    DFAgentDescription template = new DFAgentDescription();
    template.addServices(service);
    SearchConstraints all = new SearchConstraints();
    all.setMaxResults(-1L);
    // They know nothing of a stepped clock, which would go on while they look.
    Clock.Ticket looking = supervisor.clock().hold("the yellow pages");
    supervisor.ask(
        DFService.createRequestMessage(
            supervisor, supervisor.getDefaultDF(), FIPAManagementVocabulary.SEARCH, template, all),
        ANSWER_WITHIN,
        answer -> {
          looking.close();
          chosen(message, asker, feature, offers(answer, feature));
        });
  }

  /** The first by name of those whom the asker may ask. */
  private void chosen(ACLMessage message, Caller asker, String feature, List<Offer> offers) {
    Optional<Offer> permitted =
        offers.stream()
            .filter(offer -> objection(asker, offer.member(), Optional.of(feature)).isEmpty())
            .findFirst();
    if (permitted.isPresent()) {
      passOn(message, asker, permitted.get().agent());
      return;
    }
    refuse(
        message,
        offers.stream()
            .flatMap(offer -> objection(asker, offer.member(), Optional.of(feature)).stream())
            .findFirst()
            .orElseGet(() -> "Nobody offers %s now.".formatted(Replies.shortened(feature))));
  }

  private static List<Offer> offers(ACLMessage answer, String feature) {
    List<Offer> offers = new ArrayList<>();
    if (answer.getPerformative() != ACLMessage.INFORM) {
      return offers;
    }
    try {
      for (DFAgentDescription entry : DFService.decodeResult(answer.getContent())) {
        String agent = entry.getName().getLocalName();
        for (var services = entry.getAllServices(); services.hasNext(); ) {
          ServiceDescription service = (ServiceDescription) services.next();
          if (service.getType().equals(feature)) {
            offers.add(new Offer(agent, member(service).orElse(agent)));
          }
        }
      }
    } catch (FIPAException e) {
      LOG.warn("The yellow pages answer unreadably: {}", e.getMessage());
    }
    offers.sort(Comparator.comparing(Offer::agent).thenComparing(Offer::member));
    return offers;
  }

  private static Optional<String> member(ServiceDescription service) {
    for (var properties = service.getAllProperties(); properties.hasNext(); ) {
      Property property = (Property) properties.next();
      if (property.getName().equals("member")) {
        return Optional.of(String.valueOf(property.getValue()));
      }
    }
    return Optional.empty();
  }

  private AccessList access() {
    return AccessList.of(containers.home());
  }

  /** Of an agent that is none of a device, who may ask anything may ask it; it says no itself. */
  private Optional<String> objection(Caller asker, String member, Optional<String> feature) {
    Home home = containers.home();
    AccessList access = AccessList.of(home);
    Device device = home.devices().get(member);
    if (device == null || access.isOpen()) {
      return Optional.empty();
    }
    if (feature.isPresent()) {
      return access.objection(asker.names(), device, feature.get());
    }
    AccessList about = new AccessList(access.about(device));
    return !about.isOpen() && about.knows(asker.names())
        ? Optional.empty()
        : Optional.of(
            "no maestro:Permission of the home lets %s ask %s for anything"
                .formatted(String.join(" or ", asker.names()), member));
  }

  private void passOn(ACLMessage message, Caller asker, String agent) {
    supervisor.reply(
        message, ACLMessage.AGREE, Words.content("refer", Words.named("agent", Words.name(agent))));
    ACLMessage passed =
        supervisor.message(
            ACLMessage.REQUEST,
            supervisor.getAID(agent),
            Words.content("refer", Words.named("asker", Words.text(asker.toString()))));
    passed.setProtocol(FIPANames.InteractionProtocol.FIPA_RECRUITING);
    passed.setConversationId(message.getConversationId());
    passed.addReplyTo(message.getSender());
    supervisor.send(passed);
    LOG.info("{} asks for a reference to {}, which is asked to accept.", asker, agent);
  }

  private void refuse(ACLMessage message, String reason) {
    LOG.info("{} gets no reference: {}", Replies.sender(message), reason);
    supervisor.refuse(message, ACLMessage.REFUSE, reason);
  }
}

package org.maestro.agents;

import jade.core.AID;
import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.function.BiFunction;
import org.maestro.members.MemberNews;
import org.maestro.members.MemberView;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.link.RatsLink;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The abstraction of a RATS member in the control layer (M24, M69): one class for all kinds of
 * devices, configured by what the member describes. It answers calls for prices, prices parameter
 * sets, performs features over the bus and says what the member says of itself. Its name is the
 * member's id.
 */
public final class GenericAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(GenericAgent.class);
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(30);

  private final String member;
  private final transient RatsLink link;
  private final transient MemberView view = new MemberView();
  private final transient MemberNews news;
  private final transient Performances performances;

  /**
   * @param describedBy reads a description (first argument) that a member (second) sent; throws a
   *     RuntimeException with one sentence when it is faulty
   */
  public GenericAgent(
      AgentTime time,
      RatsLink link,
      String member,
      BiFunction<String, String, Device> describedBy) {
    super(time);
    this.member = member;
    this.link = link;
    this.news = new MemberNews(member, view, describedBy, new Teller());
    this.performances = new Performances(this, member, link, view, news, this::say);
  }

  @Override
  protected void setup() {
    super.setup();
    addBehaviour(new PriceResponder(this, view));
    link.watch(
        changed -> {
          if (changed.id().equals(member)) {
            tell(() -> news.changed(changed));
          }
        });
  }

  /** What the member tells, told on. */
  private final class Teller implements MemberNews.Listener {
    @Override
    public void described(String description) {
      register();
      introduce(description);
    }

    @Override
    public void said(List<String> facts) {
      say(facts);
    }

    @Override
    public void lost(String reason) {
      announce("lost", reason);
    }
  }

  /** Tells the knowledge agent, and tells it again while it is too busy to answer in time. */
  private void introduce(String description) {
    ask(
        message(
            ACLMessage.REQUEST,
            knowledgeAgent(),
            Words.content(
                "inform",
                Words.named("member", Words.name(member)),
                Words.named("description", Words.text(description)))),
        ANSWER_WITHIN,
        reply -> {
          if (reply.getPerformative() == ACLMessage.INFORM && view.isReady()) {
            announce("ready", "described");
          } else if (Conversations.isOverdue(reply)) {
            if (view.isReady() && news.isCurrent(description)) {
              introduce(description);
            }
          } else if (reply.getPerformative() != ACLMessage.AGREE) {
            LOG.warn("{} is not used: {}", member, reply.getContent());
          }
        });
  }

  private void announce(String phase, String reason) {
    send(
        message(
            ACLMessage.INFORM,
            agent(CoordinatorAgent.NAME),
            Words.content(
                "inform",
                Words.named("member", Words.name(member)),
                Words.named("phase", Words.name(phase)),
                Words.named("life", Words.text(performances.life())),
                Words.named("reason", Words.text(reason)))));
  }

  private void say(List<String> facts) {
    if (!facts.isEmpty()) {
      send(
          message(
              ACLMessage.INFORM,
              knowledgeAgent(),
              Words.content(
                  "inform",
                  Words.named("source", Words.name(member)),
                  Words.named("facts", facts.stream().map(Words::text).toList()))));
    }
  }

  private AID knowledgeAgent() {
    return agent(KnowledgeAgent.NAME);
  }

  private AID agent(String localName) {
    return getAID(localName);
  }

  /** Yellow pages: a service for each feature. The receipt is not waited for. */
  private void register() {
    DFAgentDescription entry = new DFAgentDescription();
    entry.setName(getAID());
    for (FeatureType feature : view.device().orElseThrow().features()) {
      ServiceDescription service = new ServiceDescription();
      service.setType(feature.name());
      service.setName(member + "/" + feature.name());
      service.addLanguages(LANGUAGE);
      service.addOntologies(ONTOLOGY);
      service.addProtocols(FIPANames.InteractionProtocol.FIPA_REQUEST);
      entry.addServices(service);
    }
    send(DFService.createRequestMessage(this, getDefaultDF(), "register", entry, null));
  }

  @Override
  protected boolean expects(ACLMessage message) {
    return PriceResponder.isCall(message);
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      switch (content.operator()) {
        case "perform" ->
            when(message, ACLMessage.REQUEST, () -> performances.perform(message, words));
        case "cost" -> when(message, ACLMessage.REQUEST, () -> performances.cost(message, words));
        case "cancel" -> when(message, ACLMessage.CANCEL, () -> performances.cancel(words));
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                member
                    + " does not know the operator "
                    + Replies.shortened(content.operator())
                    + "; it knows perform, cost and cancel.");
      }
    }
  }

  /** A device must not move because of a message that does not order it to. */
  private void when(ACLMessage message, int performative, Runnable deed) {
    if (message.getPerformative() == performative) {
      deed.run();
    } else {
      refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "This is understood in a %s only, and this message is a %s."
              .formatted(
                  ACLMessage.getPerformative(performative).toLowerCase(),
                  BidReader.performative(message)));
    }
  }
}

package org.maestro.agents;

import jade.core.AID;
import jade.core.behaviours.Behaviour;
import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import org.maestro.coordination.Story;
import org.maestro.members.MemberNews;
import org.maestro.members.MemberView;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.link.RatsLink;
import org.maestro.sl.Content;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
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
  private final transient PriceResponder prices;
  private final transient Optional<OwnGoals> goals;
  private boolean announced;
  private transient Rights rights = Rights.UNKNOWN;
  private final transient Set<AID> listeners = new LinkedHashSet<>();
  private final transient Once objections = new Once();

  /**
   * @param describedBy reads a description (first argument) that a member (second) sent; throws a
   *     RuntimeException with one sentence when it is faulty
   */
  public GenericAgent(
      AgentTime time,
      RatsLink link,
      String member,
      BiFunction<String, String, Device> describedBy) {
    this(time, link, member, describedBy, Optional.empty(), entry -> {}, Past.none());
  }

  /**
   * @param mind with which it pursues the goals that its member's description states; empty where
   *     the collective knowledge is out of reach
   * @param story where it tells of them
   * @param past of the platform, with which they go on
   */
  public GenericAgent(
      AgentTime time,
      RatsLink link,
      String member,
      BiFunction<String, String, Device> describedBy,
      Optional<Mind> mind,
      Story story,
      Past past) {
    super(time);
    this.member = member;
    this.link = link;
    this.prices = new PriceResponder(this, view, this::objection);
    this.news = new MemberNews(member, view, describedBy, new Teller());
    this.performances = new Performances(this, member, link, view, news, this::say);
    OwnMember own = new OwnMember(member, view, performances);
    this.goals =
        mind.map(
            m ->
                new OwnGoals(
                    this, member, time.clock(), m, story, past, member::equals, Optional.of(own)));
  }

  @Override
  protected void setup() {
    super.setup();
    goals.ifPresent(OwnGoals::begin);
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
      announced = false;
      goals.ifPresent(own -> own.memberLost(member, reason));
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
            rights = Rights.read(Words.of(Words.parse(reply.getContent()).get(0)));
            announced = true;
            announce("ready", "described");
            pursue();
          } else if (Conversations.isOverdue(reply)) {
            if (view.isReady() && news.isCurrent(description)) {
              introduce(description);
            }
          } else if (reply.getPerformative() != ACLMessage.AGREE) {
            LOG.warn("{} is not used: {}", member, reply.getContent());
          }
        });
  }

  /** The goals of its own that the member's description states. */
  private void pursue() {
    goals.ifPresent(
        own -> {
          own.memberPresent(member, getAID(), Optional.of(performances.life()));
          Substitution self = new Substitution(Map.of("self", new Term.Name(member)));
          own.pursueOnly(view.device().orElseThrow().pursues().stream().map(self::apply).toList());
        });
  }

  private void announce(String phase, String reason) {
    Content news = presence(phase, reason);
    send(message(ACLMessage.INFORM, agent(CoordinatorAgent.NAME), news));
    listeners.forEach(listener -> send(message(ACLMessage.INFORM, listener, news)));
  }

  private Content presence(String phase, String reason) {
    return Words.content(
        "inform",
        Words.named("member", Words.name(member)),
        Words.named("phase", Words.name(phase)),
        Words.named("life", Words.text(performances.life())),
        Words.named("reason", Words.text(reason)));
  }

  /** Who subscribes hears at once, and then each time, whether the member can be used. */
  private void subscribe(ACLMessage message) {
    boolean isCentre = message.getSender().getLocalName().equals(CoordinatorAgent.NAME);
    if (isCentre) {
      goals.ifPresent(OwnGoals::centreReturned);
    } else {
      listeners.add(message.getSender());
    }
    if (announced) {
      send(message(ACLMessage.INFORM, message.getSender(), presence("ready", "described")));
    }
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
  protected Optional<Behaviour> session(ACLMessage message) {
    return prices.session(message);
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      switch (content.operator()) {
        case "perform" ->
            when(message, ACLMessage.REQUEST, () -> allowed(message, words, performances::perform));
        case "cost" ->
            when(message, ACLMessage.REQUEST, () -> allowed(message, words, performances::cost));
        case "cancel" -> cancel(message, words);
        case "subscribe" -> when(message, ACLMessage.SUBSCRIBE, () -> subscribe(message));
        case "query-ref" -> goals.ifPresent(own -> GoalWords.list(this, message, own));
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                member
                    + " does not know the operator "
                    + Replies.shortened(content.operator())
                    + "; it knows perform, cost, cancel, subscribe and query-ref.");
      }
    }
  }

  /** A goal of its own is cancelled like any goal, what it does for others by who ordered it. */
  private void cancel(ACLMessage message, Words words) {
    if (goals.isPresent() && words.string("goal").isPresent()) {
      GoalWords.cancel(this, message, words, goals.get());
    } else {
      when(message, ACLMessage.CANCEL, () -> performances.cancel(words));
    }
  }

  @Override
  protected void takeDown() {
    goals.ifPresent(OwnGoals::end);
    super.takeDown();
  }

  /** Only who may ask for the feature is answered (A28). */
  private void allowed(ACLMessage message, Words words, BiConsumer<ACLMessage, Words> deed) {
    objection(message, words, words.string("feature").orElse(""))
        .ifPresentOrElse(
            reason -> refuse(message, ACLMessage.REFUSE, reason),
            () -> deed.accept(message, words));
  }

  private Optional<String> objection(ACLMessage message, Words words, String feature) {
    Optional<String> objection = rights.objection(message, words, member, feature);
    objection
        .filter(objections::isNew)
        .ifPresent(reason -> LOG.warn("{} refuses: {}", member, reason));
    return objection;
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

package org.maestro.agents;

import jade.core.AID;
import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiFunction;
import org.maestro.coordination.Argument;
import org.maestro.coordination.Crew;
import org.maestro.knowledge.FeatureRun;
import org.maestro.members.CallReporter;
import org.maestro.members.JsonTerms;
import org.maestro.members.MemberNews;
import org.maestro.members.MemberView;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.Outcome;
import org.maestro.sl.Content;
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
  private final transient Map<String, RatsLink.CallHandle> handles = new TreeMap<>();

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
                Words.named("life", Words.text(life())),
                Words.named("reason", Words.text(reason)))));
  }

  /** A call is known again only in the same life of the member, from the same caller. */
  private String life() {
    return news.boot() + "@" + link.controller();
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
        case "perform" -> when(message, ACLMessage.REQUEST, () -> perform(message, words));
        case "cost" -> when(message, ACLMessage.REQUEST, () -> cost(message, words));
        case "cancel" -> when(message, ACLMessage.CANCEL, () -> cancel(words));
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

  private void perform(ACLMessage message, Words words) {
    String name = words.string("feature").orElse("");
    Optional<FeatureType> feature = view.feature(name);
    if (!view.isReady() || feature.isEmpty()) {
      refuse(
          message,
          ACLMessage.REFUSE,
          view.isReady() ? member + " has no feature " + name : member + " is not there");
      return;
    }
    if (!words.string("life").orElse(life()).equals(life())) {
      refuse(message, ACLMessage.REFUSE, member + " was started again since it was asked");
      return;
    }
    reply(
        message,
        ACLMessage.AGREE,
        Words.content("perform", Words.named("feature", Words.name(name))));
    Map<String, Argument> arguments =
        words.find("parameters").map(Orders::arguments).orElse(Map.of());
    Map<String, Object> parameters = new TreeMap<>();
    Map<String, Term> bindings = new TreeMap<>();
    arguments.forEach(
        (key, argument) -> {
          parameters.put(key, JsonTerms.json(argument));
          bindings.put(key, argument.value());
        });
    String conversation = conversation(message);
    view.begun(conversation, bindings);
    Duration timeout = Duration.ofMillis((long) words.number("timeout", 30_000));
    handles.put(
        conversation,
        link.call(
            new RatsLink.Order(
                words.string("call"),
                member,
                Optional.of(news.boot()),
                name,
                parameters,
                timeout,
                words.string("goal")),
            new CallReporter(this::tell, new Reporter(message, conversation, feature.get()))));
  }

  private static String conversation(ACLMessage message) {
    return Optional.ofNullable(message.getConversationId()).orElse("none");
  }

  private void cost(ACLMessage message, Words words) {
    String feature = words.string("feature").orElse("");
    List<Map<String, Object>> sets = new ArrayList<>();
    for (Content.Argument.Named named : words.all()) {
      if (named.name().equals("set")) {
        Map<String, Object> set = new TreeMap<>();
        Orders.arguments(Words.of(named))
            .forEach((key, argument) -> set.put(key, JsonTerms.json(argument)));
        sets.add(set);
      }
    }
    link.cost(
        member,
        feature,
        sets,
        answers ->
            tell(
                () ->
                    reply(
                        message,
                        ACLMessage.INFORM,
                        answers.stream().map(GenericAgent::price).toArray(Content[]::new))));
  }

  private static Content price(CostAnswer answer) {
    if (answer.cost().isPresent()) {
      return Words.content(
          "cost",
          Words.named(
              "price",
              Words.number(answer.cost().get()),
              Words.number(answer.seconds().orElse(answer.cost().get()))));
    }
    return Words.content(
        "cost",
        Words.named(
            answer.answered() ? "reason" : "unanswered",
            Words.text(answer.reason().orElse("no reason given"))));
  }

  private void cancel(Words words) {
    words.string("order").map(handles::get).ifPresent(RatsLink.CallHandle::cancel);
    words
        .string("call")
        .filter(call -> words.string("life").filter(life()::equals).isPresent())
        .ifPresent(call -> link.cancel(member, news.boot(), call));
  }

  /** Turns what becomes of one call into messages. */
  private final class Reporter implements CallReporter.Listener {
    private final ACLMessage order;
    private final String conversation;
    private final FeatureType feature;

    Reporter(ACLMessage order, String conversation, FeatureType feature) {
      this.order = order;
      this.conversation = conversation;
      this.feature = feature;
    }

    @Override
    public void reported(Outcome outcome, Crew.Report report) {
      if (report.succeeded()) {
        reply(
            order,
            ACLMessage.INFORM,
            Words.content("inform", Words.terms("outputs", report.outputs())));
      } else {
        failed(outcome, report);
      }
      say(view.over());
    }

    private void failed(Outcome outcome, Crew.Report report) {
      List<Content.Argument> refs = new ArrayList<>();
      for (FeatureRun.Learnt ref : report.refs()) {
        refs.add(Words.named("fact", Words.text(ref.fact()), Words.term(ref.value())));
      }
      reply(
          order,
          ACLMessage.FAILURE,
          Words.content(
              "inform",
              Words.named("outcome", Words.name(outcome.name().toLowerCase())),
              Words.named("problem", Words.text(report.problem().orElse("no reason given"))),
              Words.named("refs", refs)));
    }

    @Override
    public void learnt(Map<String, Term> outputs) {
      send(
          message(
              ACLMessage.INFORM,
              knowledgeAgent(),
              Words.content(
                  "inform",
                  Words.named("member", Words.name(member)),
                  Words.named("feature", Words.name(feature.name())),
                  Words.terms("bindings", view.bindings(conversation)),
                  Words.terms("outputs", outputs))));
    }

    @Override
    public void over() {
      handles.remove(conversation);
      view.forget(conversation);
    }
  }
}

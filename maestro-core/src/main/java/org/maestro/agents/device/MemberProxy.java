package org.maestro.agents.device;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.agents.calls.ActionExecution;
import org.maestro.agents.calls.Arbitration;
import org.maestro.agents.calls.FormerCalls;
import org.maestro.agents.calls.OwnMember;
import org.maestro.agents.calls.PriceQuestions;
import org.maestro.agents.content.AccountWords;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.goals.OwnGoals;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Stakes;
import org.maestro.deployment.Charge;
import org.maestro.knowledge.api.MemberCondition;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.members.DescriptionVerdict;
import org.maestro.members.MemberNews;
import org.maestro.members.MemberOrders;
import org.maestro.members.MemberView;
import org.maestro.ontology.home.Device;
import org.maestro.rats.link.RatsLink;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Substitution;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The proxy of one member within its generic agent: it hears what the member tells, makes it known,
 * and has it do what is ordered. Agent thread only.
 */
public final class MemberProxy implements MemberNews.Listener {
  private static final Logger LOG = LoggerFactory.getLogger(MemberProxy.class);

  /** Whom the agent tells that a member can be used, or can be used no longer. */
  public interface Announcements {
    void announce(Content news);

    /** What the agent's members offer is not what it was. */
    void offeringChanged();
  }

  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(30);

  /** Whoever answers this has taken in what it was told before. */
  private static final Formula TRUE = new Formula.And(List.of());

  private final MaestroAgent agent;
  private final Announcements announcements;
  private final String member;
  private final Surroundings here;
  private final MemberView view;
  private final MemberNews news;
  private final MemberOrders orders;
  private final ActionExecution actions;
  private final Arbitration arbitration;
  private final PriceQuestions prices;
  private final Optional<OwnGoals> goals;
  private Optional<String> configured;
  private Rights rights = Rights.UNKNOWN;
  private boolean announced;
  private boolean wasLost;
  private boolean hasSpoken;
  private Optional<MemberCondition> condition = Optional.empty();
  private Runnable unwatch = () -> {};

  public MemberProxy(
      MaestroAgent agent,
      Announcements announcements,
      Charge charge,
      Surroundings here,
      FormerCalls formerCalls) {
    this.agent = agent;
    this.announcements = announcements;
    this.member = charge.member();
    this.configured = charge.description();
    this.here = here;
    this.view =
        new MemberView(
            "%s of %s since %d"
                .formatted(
                    member, here.link().controller(), here.time().clock().instant().toEpochMilli()),
            () -> here.link().describe(member));
    this.news = new MemberNews(member, view, this::read, this);
    this.orders =
        new MemberOrders(member, here.link(), view, agent::tell, here.time().clock(), this::say);
    this.arbitration = new Arbitration(agent, member);
    this.actions =
        new ActionExecution(
            agent, member, here.link(), view, news, orders, formerCalls, arbitration);
    this.prices = new PriceQuestions(agent, orders);
    OwnMember own = new OwnMember(member, orders, actions, arbitration, agent::tell);
    this.goals =
        here.mind()
            .map(
                mind ->
                    new OwnGoals(
                        agent,
                        member,
                        here.time().clock(),
                        mind,
                        here.story(),
                        here.past(),
                        member::equals,
                        Optional.of(own)));
    goals.ifPresent(its -> arbitration.ownManager(its::askedToYield, its::heard));
  }

  /** What the agent is configured with goes before what the member says of itself. */
  private Device read(String description, String speaker) {
    return here.describedBy().apply(configured.orElse(description), speaker);
  }

  public void begin() {
    goals.ifPresent(OwnGoals::begin);
    unwatch = here.link().watch(member, new Ear());
  }

  public void end() {
    unwatch.run();
    goals.ifPresent(OwnGoals::end);
  }

  /**
   * Is configured otherwise from now on.
   *
   * @throws RuntimeException with one sentence when the description is faulty
   */
  public void configure(Optional<String> description) {
    description.ifPresent(
        text -> {
          Device unusedAsOnlyFaultsCountHere = here.describedBy().apply(text, member);
        });
    configured = description;
    news.readAgain();
  }

  public String member() {
    return member;
  }

  public MemberView view() {
    return view;
  }

  public ActionExecution actions() {
    return actions;
  }

  /** Who may use what of the member, where several managers of goals want it. */
  public Arbitration arbitration() {
    return arbitration;
  }

  /**
   * Why who asks may not stand in the queue for these components: none of the features that use
   * them is for it; empty when one is.
   */
  public Optional<String> objectionToUse(ACLMessage message, Words words, Set<String> components) {
    return view.device().stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.occupies().stream().anyMatch(components::contains))
        .map(feature -> objection(message, words, feature.name()))
        .reduce((one, other) -> one.isEmpty() ? one : other)
        .orElse(Optional.empty());
  }

  public PriceQuestions prices() {
    return prices;
  }

  public Optional<OwnGoals> goals() {
    return goals;
  }

  /**
   * Has the member tell once more what it says of itself.
   *
   * @param known is run once: what it says is known now, or it says nothing
   */
  public void tellAgain(Runnable known) {
    orders.tellAgain(
        () ->
            agent.ask(
                agent.message(
                    ACLMessage.REQUEST,
                    agent.getAID(AgentNames.KNOWLEDGE),
                    Words.content("query-if", Words.formula(TRUE))),
                ANSWER_WITHIN,
                answeredBehindWhatWasSaid -> known.run()));
  }

  /** Whether it has goals of its own, which only an agent that reaches the knowledge can have. */
  public boolean pursues() {
    return view.device().filter(device -> !device.pursues().isEmpty()).isPresent();
  }

  /** From now on these are the rights to ask for its features, whatever was told before. */
  public void permit(Words words) {
    rights = Rights.read(words);
  }

  /** Why who asks may not ask for the feature. */
  Optional<String> objection(ACLMessage message, Words words, String feature) {
    return rights.objection(message, words, member, feature);
  }

  @Override
  public void described(String description) {
    announcements.offeringChanged();
    introduce(description);
  }

  @Override
  public void refused(RuntimeException why) {
    here.link().tell(DescriptionVerdict.refused(member, news.boot(), why));
    notUsed(DescriptionVerdict.inSentences(why));
  }

  /** It was used as it had described itself before, and is not any more, though it is there. */
  private void notUsed(String why) {
    if (announced || wasLost) {
      lost("its description is refused: " + why);
    }
  }

  @Override
  public void said(MemberWord word) {
    say(word);
  }

  @Override
  public void lost(String reason) {
    announced = false;
    wasLost = true;
    goals.ifPresent(own -> own.memberLost(member, reason));
    announcements.announce(presence("lost", reason));
    announcements.offeringChanged();
  }

  /** What the member is at is told as soon as it changes, also while a call runs. */
  private void tellCondition(RatsLink.Member now) {
    Optional<MemberCondition> told =
        now.state()
            .filter(itsState -> view.isReady())
            .map(state -> new MemberCondition(state.state(), !state.running().isEmpty()));
    if (!told.equals(condition)) {
      condition = told;
      told.ifPresent(
          changed ->
              agent.send(
                  agent.message(
                      ACLMessage.INFORM,
                      agent.getAID(AgentNames.KNOWLEDGE),
                      AccountWords.condition(member, changed))));
    }
  }

  /** Told on the link's thread. */
  private final class Ear implements RatsLink.MemberListener {
    @Override
    public void changed(RatsLink.Member now) {
      agent.tell(
          () -> {
            news.changed(now);
            tellCondition(now);
          });
    }

    @Override
    public void alerted(String speaker, String callId, String message) {
      agent.tell(() -> actions.alarmed(callId, message));
    }
  }

  /** Tells the knowledge agent, and tells it again while it is too busy to answer in time. */
  private void introduce(String description) {
    agent.ask(
        agent.message(
            ACLMessage.REQUEST,
            agent.getAID(AgentNames.KNOWLEDGE),
            Words.content(
                "inform",
                Words.named("member", Words.name(member)),
                Words.named("description", Words.text(configured.orElse(description))))),
        ANSWER_WITHIN,
        reply -> {
          if (reply.getPerformative() == ACLMessage.INFORM && view.isReady()) {
            rights = Rights.read(Words.of(Words.parse(reply.getContent()).get(0)));
            here.link().tell(DescriptionVerdict.accepted(member, news.boot()));
            announced = true;
            wasLost = false;
            announcements.announce(presence("ready", "described"));
            pursue();
          } else if (Conversations.isOverdue(reply)) {
            if (view.isReady() && news.isCurrent(description)) {
              introduce(description);
            }
          } else if (reply.getPerformative() != ACLMessage.AGREE
              && reply.getPerformative() != ACLMessage.INFORM) {
            LOG.warn("{} is not used: {}", member, reply.getContent());
            String why = Replies.reason(reply).orElse("cannot be used");
            here.link().tell(DescriptionVerdict.refused(member, news.boot(), why));
            notUsed(why);
          }
        });
  }

  /** The goals of its own that the member's description states. */
  private void pursue() {
    goals.ifPresent(
        own -> {
          own.memberPresent(member, agent.getAID(), Optional.of(actions.life()));
          Substitution self = new Substitution(Self.is(member));
          Device device = view.device().orElseThrow();
          own.pursueOnly(
              device.pursues().stream().map(self::apply).toList(),
              Stakes.of(device.worth(), self::apply));
        });
  }

  /** That the member can be used, if it can. */
  public Optional<Content> presence() {
    return announced ? Optional.of(presence("ready", "described")) : Optional.empty();
  }

  private Content presence(String phase, String reason) {
    return Words.content(
        "inform",
        Words.named("member", Words.name(member)),
        Words.named("phase", Words.name(phase)),
        Words.named("life", Words.text(actions.life())),
        Words.named("reason", Words.text(reason)));
  }

  /** Of one that never says anything of itself there is nothing to withdraw. */
  private void say(MemberWord word) {
    hasSpoken |= !word.facts().isEmpty();
    if (hasSpoken) {
      agent.send(
          agent.message(
              ACLMessage.INFORM,
              agent.getAID(AgentNames.KNOWLEDGE),
              new Content("inform", AccountWords.of(member, word))));
    }
  }
}

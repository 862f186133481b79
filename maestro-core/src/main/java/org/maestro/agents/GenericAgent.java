package org.maestro.agents;

import jade.core.AID;
import jade.core.ServiceException;
import jade.core.behaviours.Behaviour;
import jade.core.behaviours.OneShotBehaviour;
import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.maestro.agents.calls.FormerCalls;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.device.DirectoryEntry;
import org.maestro.agents.device.HostService;
import org.maestro.agents.device.MemberProxy;
import org.maestro.agents.device.Movement;
import org.maestro.agents.device.PriceResponder;
import org.maestro.agents.device.RequestGuard;
import org.maestro.agents.device.Settling;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.device.ToldRights;
import org.maestro.agents.goals.OwnGoalRequests;
import org.maestro.agents.goals.OwnGoals;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Charge;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.DeviceFile;
import org.maestro.rats.security.SitePersons;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The abstraction of RATS members in the control layer (Three-layered architecture, 3 and 3.3.2;
 * M24, M68, M69, M71): one class for all kinds of devices, made what it is by its configuration and
 * by what its members describe. It answers calls for prices, prices parameter sets, performs
 * features over the bus and says what its members say of themselves.
 *
 * <p>JADE can make it by its class name, in any container of MAESTRO, also from its GUI: with the
 * path of a device file as argument, or with none for a member of the agent's name. Started so it
 * registers with the supervisor before it does anything (ADE, 3.1; A20), on a secured site with two
 * arguments more: the name of a person, and the path of the file with her password; {@code -} takes
 * the place of a device file. It can move; it then goes as soon as nothing is under way.
 */
public final class GenericAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(GenericAgent.class);

  private static final Duration REGISTERED_WITHIN = Duration.ofSeconds(60);
  private static final String NO_FILE = "-";

  private final LinkedHashSet<AID> listeners = new LinkedHashSet<>();
  private final FormerCalls formerCalls = new FormerCalls();
  private final DirectoryEntry entry = new DirectoryEntry();

  /** How it was started, in words: this is what travels. */
  private String configuration = "";

  private @Nullable Movement movement;

  /** Whether the supervisor has not started it, and has not taken it in yet. */
  private boolean isStranger;

  private transient Optional<Surroundings> here = Optional.empty();
  private transient Map<String, MemberProxy> proxies = Map.of();

  // JADE has an agent set itself up in each container before it acts, and where it is cannot be
  // known earlier.
  @SuppressWarnings("NullAway.Init")
  private transient PriceResponder prices;

  @SuppressWarnings("NullAway.Init")
  private transient Settling settling;

  @SuppressWarnings("NullAway.Init")
  private transient RequestGuard door;

  /** Made by JADE, which has its arguments. */
  public GenericAgent() {
    // What it is to be stands in its arguments, what it works with comes from its container.
  }

  /**
   * @param here what its container gives to it
   * @param start what it is to be
   */
  public GenericAgent(Birth birth, Surroundings here, AgentStart start) {
    super(birth, here.time());
    this.here = Optional.of(here);
    this.configuration = Words.print(StartWords.content(start));
  }

  /** Arrived from another container. */
  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    here = Optional.empty();
    proxies = Map.of();
  }

  @Override
  protected AgentTime timeHere() {
    try {
      Surroundings given = ((HostService.Access) getHelper(HostService.NAME)).host().surroundings();
      here = Optional.of(movement == null ? given : given.afterMove());
      return given.time();
    } catch (ServiceException e) {
      throw new IllegalStateException(
          "This container is none of MAESTRO's: choose another, or join one with ./maestro"
              + " container.",
          e);
    }
  }

  @Override
  protected void setup() {
    super.setup();
    try {
      begin(configured());
    } catch (RuntimeException e) {
      LOG.error("The agent {} ends: {}", getLocalName(), e.getMessage());
      doDelete();
    }
  }

  private void begin(AgentStart start) {
    Surroundings surroundings = here.orElseThrow();
    Map<String, MemberProxy> all = new LinkedHashMap<>();
    for (Charge charge : start.charges()) {
      all.put(
          charge.member(), new MemberProxy(this, new Told(), charge, surroundings, formerCalls));
    }
    proxies = all;
    door = new RequestGuard(this, all);
    Optional<String> mark = all.size() > 1 ? Optional.of(getLocalName()) : Optional.empty();
    prices =
        new PriceResponder(
            this, words -> door.proxy(words).map(MemberProxy::view), door::objection, mark);
    settling =
        new Settling(
            clock(),
            clock().isStepped() ? Duration.ZERO : patience(Settling.LONGEST),
            () -> all.values().stream().allMatch(proxy -> proxy.view().isReady()),
            this::tell);
    if (isStranger) {
      register(start);
    } else {
      all.values().forEach(MemberProxy::begin);
    }
  }

  /** Who shows no name and password where those are wanted is nobody's agent, and ends. */
  private void register(AgentStart start) {
    ask(
        message(
            ACLMessage.REQUEST,
            getAID(AgentNames.SUPERVISOR),
            StartWords.registration(start, shown())),
        REGISTERED_WITHIN,
        reply -> {
          if (reply.getPerformative() == ACLMessage.INFORM) {
            isStranger = false;
            proxies.values().forEach(MemberProxy::begin);
          } else if (Conversations.isFinal(reply)) {
            LOG.error(
                "The agent {} ends, as it is not registered: {}",
                getLocalName(),
                Replies.reason(reply).orElse("no supervisor answers."));
            doDelete();
          }
        });
  }

  private Optional<StartWords.Shown> shown() {
    Object[] arguments = getArguments();
    return arguments == null || arguments.length < 3
        ? Optional.empty()
        : Optional.of(
            new StartWords.Shown(
                String.valueOf(arguments[1]).strip(),
                SitePersons.passwordIn(Path.of(String.valueOf(arguments[2]).strip()))));
  }

  /** How it is to begin: as it was told, as it was before it moved, or as its arguments say. */
  private AgentStart configured() {
    Object[] arguments = getArguments();
    if (configuration.isEmpty() && arguments != null && arguments.length > 0) {
      String first = String.valueOf(arguments[0]).strip();
      configuration = first.startsWith("(" + StartWords.OPERATOR) ? first : "";
      if (configuration.isEmpty() && !first.equals(NO_FILE)) {
        startedByHand(started(Path.of(first)));
      }
    }
    if (configuration.isEmpty()) {
      startedByHand(AgentStart.of(getLocalName(), here().getName()));
    }
    return StartWords.read(Words.of(Words.parse(configuration).get(0)));
  }

  private AgentStart started(Path file) {
    List<DeviceFile.Described> devices =
        new DeviceFile(here.orElseThrow().describedBy()).read(file);
    List<Charge> charges =
        devices.stream().map(d -> new Charge(d.id(), Optional.of(d.text()))).toList();
    String container = here().getName();
    return new AgentStart(getLocalName(), charges, container, Set.of(), container);
  }

  /** The supervisor has to take in an agent that it did not start. */
  private void startedByHand(AgentStart start) {
    configuration = Words.print(StartWords.content(start));
    isStranger = true;
  }

  private void announce(Content news) {
    send(message(ACLMessage.INFORM, getAID(AgentNames.COORDINATOR), news));
    listeners.forEach(listener -> send(message(ACLMessage.INFORM, listener, news)));
  }

  /** Who subscribes hears at once, and then each time, whether the members can be used. */
  private void subscribe(ACLMessage message) {
    if (message.getSender().getLocalName().equals(AgentNames.COORDINATOR)) {
      proxies.values().forEach(proxy -> proxy.goals().ifPresent(OwnGoals::centreReturned));
    } else {
      listeners.add(message.getSender());
    }
    proxies
        .values()
        .forEach(
            proxy ->
                proxy
                    .presence()
                    .ifPresent(
                        news -> send(message(ACLMessage.INFORM, message.getSender(), news))));
  }

  /** Makes the agent's entry in the yellow pages what it has to be now. */
  private void registerServices() {
    entry.renew(this, this::offering);
  }

  private Map<String, Device> offering() {
    Map<String, Device> offering = new LinkedHashMap<>();
    proxies.forEach(
        (member, proxy) ->
            proxy
                .view()
                .device()
                .filter(device -> proxy.view().isReady())
                .ifPresent(device -> offering.put(member, device)));
    return offering;
  }

  @Override
  protected boolean opensSession(ACLMessage message) {
    return proxies.size() > 1 && message.getPerformative() == ACLMessage.CFP;
  }

  @Override
  protected Optional<Behaviour> session(ACLMessage message) {
    Optional<Behaviour> session = prices.session(message);
    return settling.isOver() ? session : session.map(Later::new);
  }

  /**
   * A deferred session of an agent that has just taken over from a lost one: before it has settled
   * it would refuse for want of its members.
   */
  private final class Later extends OneShotBehaviour {
    private static final long serialVersionUID = 1L;
    private final transient Behaviour session;

    Later(Behaviour session) {
      this.session = session;
    }

    @Override
    public void action() {
      settling.once(() -> addBehaviour(session));
    }
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      switch (content.operator()) {
        case "perform" ->
            settling.once(
                () -> door.when(message, ACLMessage.REQUEST, () -> perform(message, words)));
        case "cost" ->
            door.when(
                message,
                ACLMessage.REQUEST,
                () -> door.allowed(message, words, proxy -> proxy.prices().cost(message, words)));
        case "want" ->
            door.when(
                message,
                ACLMessage.REQUEST,
                () -> door.mayUse(message, words, its -> its.arbitration().want(message, words)));
        case "give-back" ->
            door.when(
                message,
                ACLMessage.REQUEST,
                () ->
                    door.asked(message, words, its -> its.arbitration().giveBack(message, words)));
        case "describe" -> door.when(message, ACLMessage.REQUEST, () -> describe(message, words));
        case ToldRights.OPERATOR ->
            door.when(message, ACLMessage.REQUEST, () -> permit(message, words));
        case "cancel" -> cancel(message, words);
        case "subscribe" -> door.when(message, ACLMessage.SUBSCRIBE, () -> subscribe(message));
        case "query-ref" ->
            proxies.values().stream()
                .flatMap(proxy -> proxy.goals().stream())
                .findFirst()
                .ifPresent(own -> new OwnGoalRequests(this, own).list(message));
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                getLocalName()
                    + " does not know the operator "
                    + Replies.shortened(content.operator())
                    + "; it knows perform, cost, want, give-back, describe, cancel, subscribe and"
                    + " query-ref.");
      }
    }
  }

  private void perform(ACLMessage message, Words words) {
    Optional<String> action = words.string("action");
    if (action.isEmpty()) {
      door.allowed(message, words, proxy -> proxy.actions().perform(message, words));
    } else if (!message.getSender().equals(getAID(AgentNames.SUPERVISOR))) {
      refuse(
          message,
          ACLMessage.REFUSE,
          "Only the supervisor has an agent move or configures it; ask the CCA.");
    } else if (action.get().equals("move")) {
      move(message, words.string("container").orElse(""));
    } else {
      configure(message, words);
    }
  }

  /** Who may ask what is told by the knowledge agent, which has it of the home's file. */
  private void permit(ACLMessage message, Words words) {
    if (!message.getSender().equals(getAID(AgentNames.KNOWLEDGE))) {
      refuse(
          message,
          ACLMessage.REFUSE,
          "Who may ask for what stands in the home's file; only the knowledge agent tells it.");
      return;
    }
    door.asked(
        message,
        words,
        proxy -> {
          proxy.permit(words);
          reply(
              message,
              ACLMessage.INFORM,
              Words.content("inform", Words.named("done", Words.name(ToldRights.OPERATOR))));
        });
  }

  private void describe(ACLMessage message, Words words) {
    door.asked(
        message,
        words,
        proxy ->
            proxy.tellAgain(
                () ->
                    reply(
                        message,
                        ACLMessage.INFORM,
                        Words.content("inform", Words.named("done", Words.name("described"))))));
  }

  private void move(ACLMessage message, String container) {
    Optional<MemberProxy> tied = proxies.values().stream().filter(MemberProxy::pursues).findFirst();
    if (clock().isStepped()) {
      refuse(message, ACLMessage.REFUSE, "On a stepped clock agents stay where they are.");
    } else if (tied.isPresent()) {
      refuse(
          message,
          ACLMessage.REFUSE,
          "%s stays where the collective knowledge is, as it has goals of its own (maestro:pursues)."
              .formatted(tied.get().member()));
    } else {
      reply(
          message,
          ACLMessage.AGREE,
          Words.content("perform", Words.named("action", Words.name("move"))));
      movement = new Movement(message, container);
      movement.goWhen(
          this, this::isIdle, () -> stay(message, "is still at what it was ordered to do"));
    }
  }

  private boolean isIdle() {
    return prices.isIdle()
        && conversations().openCount() == 0
        && proxies.values().stream().allMatch(proxy -> proxy.actions().isIdle());
  }

  private void stay(ACLMessage asked, String why) {
    refuse(asked, ACLMessage.FAILURE, getLocalName() + " " + why + ".");
    movement = null;
  }

  private void configure(ACLMessage message, Words words) {
    List<Charge> charges = StartWords.charges(words);
    try {
      charges.forEach(
          charge ->
              Optional.ofNullable(proxies.get(charge.member()))
                  .ifPresent(proxy -> proxy.configure(charge.description())));
      AgentStart start = StartWords.read(Words.of(Words.parse(configuration).get(0)));
      configuration = Words.print(StartWords.content(start.with(charges)));
      reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("done", Words.name("configure"))));
    } catch (RuntimeException e) {
      refuse(message, ACLMessage.REFUSE, String.valueOf(e.getMessage()));
    }
  }

  /** A goal of its own is cancelled like any goal, what it does for others by who ordered it. */
  private void cancel(ACLMessage message, Words words) {
    Optional<OwnGoals> own =
        proxies.values().stream().flatMap(proxy -> proxy.goals().stream()).findFirst();
    if (own.isPresent() && words.string("goal").isPresent()) {
      new OwnGoalRequests(this, own.get()).cancel(message, words);
    } else {
      door.when(
          message,
          ACLMessage.CANCEL,
          () -> proxies.values().forEach(proxy -> proxy.actions().cancel(words)));
    }
  }

  /** What runs is ended if JADE's own tools have it move at once; who waits is told. */
  @Override
  protected void beforeMove() {
    Set<String> lives = new TreeSet<>();
    for (MemberProxy proxy : proxies.values()) {
      lives.add(proxy.actions().life());
      proxy.actions().abandon();
      proxy.end();
    }
    formerCalls.moves(lives);
    if (movement == null) {
      movement = new Movement(new ACLMessage(ACLMessage.REQUEST), "");
    }
    super.beforeMove();
  }

  @Override
  protected void afterMove() {
    super.afterMove();
    ACLMessage asked = Objects.requireNonNull(movement).request();
    movement = null;
    if (asked.getSender() != null) {
      reply(
          asked,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("container", Words.name(here().getName()))));
    }
  }

  @Override
  protected void takeDown() {
    proxies.values().forEach(MemberProxy::end);
    super.takeDown();
  }

  private final class Told implements MemberProxy.Announcements {
    @Override
    public void announce(Content news) {
      GenericAgent.this.announce(news);
    }

    @Override
    public void offeringChanged() {
      registerServices();
    }
  }
}

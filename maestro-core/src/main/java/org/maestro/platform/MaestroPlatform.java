package org.maestro.platform;

import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import java.awt.GraphicsEnvironment;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.maestro.agents.CoordinatorAgent;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.GroupAgent;
import org.maestro.agents.KnowledgeAgent;
import org.maestro.agents.SupervisorAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.HeldReport;
import org.maestro.agents.device.Host;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.supervision.SupervisorOrders;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Story;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Deployment;
import org.maestro.deployment.Directory;
import org.maestro.deployment.Provision;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Device;
import org.maestro.planning.api.Planner;
import org.maestro.platform.failover.AgentFailover;
import org.maestro.platform.failover.FormerCallers;
import org.maestro.platform.failover.HostSupervisor;
import org.maestro.platform.failover.OtherNames;
import org.maestro.platform.failover.SignsOfLife;
import org.maestro.platform.failover.TakeoverLinks;
import org.maestro.platform.jade.AgentsByName;
import org.maestro.platform.jade.ContainerEnds;
import org.maestro.platform.jade.JadeDirectory;
import org.maestro.platform.jade.JadeRuntime;
import org.maestro.platform.jade.PlatformEvents;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.jade.Premises;
import org.maestro.platform.jade.SharedParts;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;

/**
 * A running platform in this process: a JADE main container with CCA, knowledge agent, supervisor
 * and desk, and an abstraction container for each topic with a generic agent for each device
 * (Three-layered architecture, 3.3.1 and 3.3.2; M64, M68-M72). Any thread may use it.
 */
public final class MaestroPlatform implements AutoCloseable {
  private static final String GROUPS = "groups";

  /** Containers that have outlived a platform have joined the next one by then. */
  private static final Duration RETURN = Duration.ofSeconds(15);

  private final long sinceNanos = System.nanoTime();
  private final PlatformSettings settings;
  private final AgentTime time;
  private final RatsLink link;
  private final TakeoverLinks heirs;
  private final KnowledgeBase knowledge;
  private final BiFunction<String, String, Device> describedBy;
  private final PlatformMemory memory;
  private final JadeDirectory files;
  private final AgentContainer main;
  private final Host host;
  private final Deployer deployer;
  private final Directory directory = new Directory();
  private final PlatformTables tables;
  private final ReasoningServices mind;
  private final Past past;
  private final CentralAgent central;
  private final Principals principals;
  private final DeskAgent desk;
  private final SupervisorAgent supervisor;
  private final AgentFailover rescue;
  private final HostSupervisor starter;
  private final Arrivals arrivals;
  private final Departures departures;
  private final RevokedNames revokedNames;
  private final SignsOfLife signs;
  private volatile boolean closing;
  private final StoriesTold stories = new StoriesTold();

  private MaestroPlatform(
      PlatformSettings settings,
      KnowledgeBase knowledge,
      Planner planner,
      RatsLink link,
      TakeoverLinks heirs,
      OtherNames otherNames,
      Clock clock,
      BiFunction<String, String, Device> describedBy,
      PlatformMemory memory,
      JadeDirectory files,
      Host host,
      SharedParts shared,
      AgentContainer main) {
    this.settings = settings;
    this.time = AgentTime.of(clock, settings.patience());
    this.link = link;
    this.heirs = heirs;
    this.describedBy = describedBy;
    this.memory = memory;
    this.files = files;
    this.main = main;
    this.knowledge = knowledge;
    this.host = host;
    this.mind = new ReasoningServices(knowledge, planner, settings.decisionTime());
    this.past = memory.past();
    Surroundings here = new Surroundings(time, link, describedBy, Optional.of(mind), stories, past);
    host.give(here);
    this.deployer =
        new Deployer(
            here,
            (name, its) ->
                JadeRuntime.join(
                    Optional.of(settings.name()),
                    settings.premises().host(),
                    settings.port(),
                    name,
                    files.path(),
                    new JadeRuntime.Entry(settings.guard(), false, settings.premises().host()),
                    its,
                    shared),
            heirs,
            new AgentsByName(settings.name(), host, agent -> directory.find(agent).isPresent()),
            settings.premises().provides());
    this.tables = new PlatformTables(deployer.deployment(), directory, clock::instant);
    this.central =
        new CentralAgent(
            past.ofCentre(),
            clock,
            before ->
                new CoordinatorAgent(
                    time, knowledge, planner, stories, settings.decisionTime(), before));
    this.principals = new Principals(central);
    this.desk = new DeskAgent(time);
    this.rescue =
        new AgentFailover(
            new FailoverWays(knowledge::home, deployer, this::orders, central::now),
            clock,
            Provision.of(settings.premises().provides()),
            link.controller(),
            otherNames::mayBeUsed);
    this.starter =
        new HostSupervisor(
            settings.premises().hosts(),
            settings.premises().host() + ":" + settings.port(),
            settings.dataDirectory().orElseGet(files::path),
            deployer::isElsewhere);
    this.arrivals =
        new Arrivals(
            knowledge,
            describedBy,
            clock,
            deployer,
            rescue,
            FormerCallers.of(past.recovery(), link.controller()));
    this.departures = new Departures(deployer, rescue, starter, desk, principals, () -> closing);
    this.revokedNames =
        new RevokedNames(deployer, otherNames::mayBeUsed, principals, clock, () -> closing);
    this.signs =
        new SignsOfLife(
            clock,
            settings.heartbeats(),
            pulse ->
                new FailureHandler(
                    pulse,
                    shared.wires(),
                    deployer,
                    central::now,
                    agent -> departures.replaceHung(pulse, agent)));
    this.supervisor =
        new SupervisorAgent(
            time,
            link,
            new Supervision(
                settings,
                deployer,
                tables,
                describedBy,
                () -> knowledge.home().words(),
                new PlatformCentre(
                    arrivals, principals, this::reviveCoordinator, rescue, this::orders, signs)));
  }

  private SupervisorOrders orders() {
    return supervisor.orders();
  }

  /**
   * Boots the platform.
   *
   * @param knowledge of the home whose devices get agents; closed with the platform
   * @param otherNames connects under another controller's name, for its calls
   * @param describedBy reads a description (first argument) that a member (second) sent
   * @throws PlatformStartException when the port is taken, or there is no display for the GUI
   */
  public static MaestroPlatform start(
      PlatformSettings settings,
      KnowledgeBase knowledge,
      Planner planner,
      RatsLink link,
      OtherNames otherNames,
      Clock clock,
      BiFunction<String, String, Device> describedBy) {
    if (settings.gui() && GraphicsEnvironment.isHeadless()) {
      throw new PlatformStartException(
          "There is no display for the JADE GUI; run without --gui, or set DISPLAY.");
    }
    PlatformSettings claimed = settings.claimed();
    PlatformMemory memory = PlatformMemory.open(settings, knowledge, clock);
    JadeDirectory files = JadeDirectory.fresh();
    Host host = new Host();
    SharedParts shared = SharedParts.fresh();
    AgentContainer main =
        JadeRuntime.main(
            claimed.name(),
            claimed.port(),
            files.path(),
            host,
            claimed.guard(),
            shared,
            claimed.premises());
    MaestroPlatform platform =
        new MaestroPlatform(
            claimed,
            knowledge,
            planner,
            link,
            new TakeoverLinks(otherNames),
            otherNames,
            clock,
            describedBy,
            memory,
            files,
            host,
            shared,
            main);
    platform.boot();
    return platform;
  }

  private void boot() {
    PlatformEvents.watch(host, directory, time.clock()::instant, departures);
    memory.stories().ifPresent(stories::addListener);
    accept(AgentNames.KNOWLEDGE, new KnowledgeAgent(time, knowledge, describedBy));
    accept(AgentNames.COORDINATOR, central.now());
    accept(AgentNames.SUPERVISOR, supervisor);
    accept("desk", desk);
    arrivals.ofHome();
    for (var group : knowledge.home().groups().values()) {
      GroupAgent agent = new GroupAgent(time, mind, group, stories, past);
      principals.add(agent);
      deployer.placeGroup(group.id(), group.container().orElse(GROUPS), agent);
    }
    link.watch(
        member -> {
          tables.memberChanged(member);
          arrivals.memberChanged(member);
        });
    if (settings.guard().isPresent()) {
      revokedNames.watch();
    }
    starter.begin(past.ofCentre().recovery().equals(Recovery.NOTHING) ? Duration.ZERO : RETURN);
    if (settings.gui()) {
      JadeRuntime.showGui(main);
    }
  }

  /**
   * Starts the central agent again after it was ended; its goals go on.
   *
   * @return false when it is there
   */
  public boolean reviveCoordinator() {
    return !closing
        && central.revive(
            revived -> {
              accept(AgentNames.COORDINATOR, revived);
              revived.ask(deployer.deployment().agents().stream().map(AgentStart::agent).toList());
            });
  }

  /**
   * Ends an agent of the main container, as a person does in the JADE GUI.
   *
   * @throws PlatformStartException when there is none of that name
   */
  public void endAgent(String name) {
    try {
      main.getAgent(name).kill();
    } catch (ControllerException e) {
      throw new PlatformStartException("There is no agent " + name + " to end.", e);
    }
  }

  private void accept(String name, MaestroAgent agent) {
    JadeRuntime.start(main, name, agent);
  }

  /**
   * Tells the listener of every sentence of every story from now on, on the coordinator's thread.
   */
  public void onStory(Story listener) {
    stories.addListener(listener);
  }

  /** The members that the CCA can use now. */
  public Collection<String> presentMembers() {
    return central.now().presentMembers();
  }

  public KnowledgeBase knowledge() {
    return knowledge;
  }

  /** Members whose agents need what no host that is there provides. */
  public Set<String> homeless() {
    return rescue.homeless();
  }

  /** Where goals are stated. */
  public DeskAgent desk() {
    return desk;
  }

  /**
   * States a goal at the desk. The report comes once, at the end, on the desk's thread; of a held
   * goal, which ends when it is cancelled, its story tells how it fares.
   *
   * @param accepted is told the goal's id as soon as the CCA has it; not called when it refuses
   */
  public void pursue(Formula goal, Consumer<String> accepted, Consumer<GoalReport> ended) {
    desk.requestGoal(
        goal,
        reply -> {
          if (reply.getPerformative() == ACLMessage.AGREE) {
            accepted.accept(GoalReport.acceptedId(reply.getContent()));
          } else if (DeskAgent.isEnd(reply)) {
            ended.accept(GoalReport.read(reply.getContent()));
          }
        });
  }

  /**
   * States a goal that is to be held.
   *
   * @param told each time that it begins or ceases to be so, and when it was found that it cannot
   *     be
   */
  public void hold(Formula goal, Consumer<HeldReport> told) {
    desk.requestGoal(
        goal,
        reply -> {
          int performative = reply.getPerformative();
          if (performative == ACLMessage.CONFIRM || performative == ACLMessage.DISCONFIRM) {
            told.accept(HeldReport.read(performative == ACLMessage.CONFIRM, reply.getContent()));
          }
        });
  }

  public int port() {
    return settings.port();
  }

  /** Where this process can be reached, with the ports it has got. */
  public Premises premises() {
    return settings.premises();
  }

  /** Topics whose containers are of this process. */
  public List<String> topics() {
    return deployer.topics();
  }

  /** Whether the containers of the platform give signs of life; empty on a stepped clock. */
  public SortedMap<String, Condition> containers() {
    return signs.containers();
  }

  /** Agents that stand for members or groups. */
  public List<AgentRow> agents() {
    return tables.agents(deployer.containers());
  }

  /** Which agents stand for which members, how they were started, and where. */
  public Deployment deployment() {
    return deployer.deployment();
  }

  /** The platform's tables: agents and containers as JADE has them. */
  public Directory directory() {
    return directory;
  }

  @Override
  public void close() {
    closing = true;
    starter.close();
    // First, so that what only ends here is not taken for ended for good.
    memory.close();
    heirs.close();
    ContainerEnds.end(deployer.close(), main, host, sinceNanos);
    knowledge.close();
    files.close();
  }
}

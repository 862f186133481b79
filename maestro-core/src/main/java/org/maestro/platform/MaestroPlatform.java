package org.maestro.platform;

import java.awt.GraphicsEnvironment;
import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.maestro.agents.CoordinatorAgent;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.GroupAgent;
import org.maestro.agents.KnowledgeAgent;
import org.maestro.agents.PersonTrackerAgent;
import org.maestro.agents.SupervisorAgent;
import org.maestro.agents.centre.HostedReasoners;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.lives.AgentLives;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.Signs;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.agents.supervision.SupervisorOrders;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Story;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Deployment;
import org.maestro.deployment.Directory;
import org.maestro.dialogue.Dialogues;
import org.maestro.diary.Diary;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.habits.HabitFile;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Group;
import org.maestro.persons.HeardVoices;
import org.maestro.platform.jade.MainContainer;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.jade.Premises;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.Clock;

/**
 * A running platform in this process: a JADE main container with CCA, knowledge agent, supervisor
 * and desk, and an abstraction container for each topic with a generic agent for each device
 * (Three-layered architecture, 3.3.1 and 3.3.2; M64, M68-M72). Any thread may use it.
 */
public final class MaestroPlatform implements AutoCloseable {
  private final PlatformSettings settings;
  private final PlatformServices services;
  private final PlatformMemory memory;
  private final Past past;
  private final MainContainer main;
  private final AgentTime time;
  private final ReasoningServices mind;
  private final AgentLives lives = new AgentLives();
  private final StoriesTold stories = new StoriesTold();
  private final Dialogues dialogues;
  private final CentralAgent central;
  private final DeskAgent desk;
  private final MemberAgents agents;
  private final Spokesmen spokesmen;
  private final GroupAgents groups;
  private final PlatformTables tables;
  private final SupervisorAgent supervisor;
  private final Optional<TrackerInService> tracker;

  private MaestroPlatform(
      PlatformSettings settings,
      PlatformServices services,
      PlatformMemory memory,
      MainContainer main) {
    this.settings = settings;
    this.services = services;
    this.memory = memory;
    this.past = memory.past();
    this.main = main;
    Clock clock = services.clock();
    KnowledgeBase knowledge = services.knowledge();
    this.time = AgentTime.of(clock, settings.patience());
    this.mind = new ReasoningServices(knowledge, services.planner(), settings.decisionTime());
    this.dialogues = new Dialogues(knowledge::home, knowledge::snapshot, clock::instant);
    HeardVoices voices = new HeardVoices(knowledge);
    dialogues.listen(said -> voices.heard(said.person(), said.room()));
    Surroundings here =
        new Surroundings(
            time, services.link(), services.describedBy(), Optional.of(mind), stories, past);
    main.give(here);
    this.agents =
        new MemberAgents(
            settings,
            services,
            main,
            here,
            lives,
            past.recovery(),
            this::presentMembers,
            this::orders);
    this.spokesmen =
        new DeployedSpokesmen(
            agents.deployer().deployment(),
            knowledge::home,
            user -> settings.guard().filter(guard -> guard.isGuest(user)).isPresent());
    this.central =
        new CentralAgent(
            past.ofCentre(),
            clock,
            memory.diary()::note,
            before ->
                new CoordinatorAgent(
                    main.birth(),
                    time,
                    knowledge,
                    services.planner(),
                    stories,
                    settings.decisionTime(),
                    before,
                    dialogues,
                    HostedReasoners.found(),
                    spokesmen));
    this.desk =
        new DeskAgent(
            main.birth(),
            time,
            memory.answers(),
            room -> knowledge.home().listener(room).map(Group::id),
            spokesmen);
    this.groups =
        new GroupAgents(
            knowledge,
            lives,
            agents,
            group ->
                new GroupAgent(
                    main.birth(), time, mind, group, stories, past, dialogues, spokesmen));
    this.tables =
        new PlatformTables(
            agents.deployer().deployment(),
            main.directory(),
            clock::instant,
            agents::refused,
            member ->
                Optional.ofNullable(knowledge.home().devices().get(member))
                    .flatMap(Device::driver));
    this.supervisor =
        new SupervisorAgent(
            main.birth(),
            time,
            services.link(),
            new Supervision(
                settings,
                agents,
                tables,
                services.describedBy(),
                knowledge::home,
                groups,
                this::reviveCoordinator),
            knowledge::home,
            spokesmen);
    this.tracker =
        knowledge
            .home()
            .tracking()
            .map(
                tracking ->
                    new TrackerInService(tracking.agent(), clock, this::tracker, main::start));
  }

  private PersonTrackerAgent tracker(String name) {
    HabitLog log =
        settings
            .dataDirectory()
            .<HabitLog>map(directory -> new HabitFile(directory, "passages.log"))
            .orElse(HabitLog.NONE);
    return new PersonTrackerAgent(main.birth(), time, services.knowledge(), name, log);
  }

  private SupervisorOrders orders() {
    return supervisor.orders();
  }

  /**
   * Boots the platform.
   *
   * @throws PlatformStartException when the port is taken, or there is no display for the GUI
   */
  public static MaestroPlatform start(PlatformSettings settings, PlatformServices services) {
    if (settings.gui() && GraphicsEnvironment.isHeadless()) {
      throw new PlatformStartException(
          "There is no display for the JADE GUI; run without --gui, or set DISPLAY.");
    }
    PlatformSettings claimed = settings.claimed();
    PlatformMemory memory = PlatformMemory.open(settings, services.knowledge(), services.clock());
    MainContainer main =
        MainContainer.boot(claimed.name(), claimed.port(), claimed.guard(), claimed.premises());
    MaestroPlatform platform = new MaestroPlatform(claimed, services, memory, main);
    platform.boot();
    return platform;
  }

  private HabitLog habitLog() {
    return settings.dataDirectory().<HabitLog>map(HabitFile::new).orElse(HabitLog.NONE);
  }

  private void boot() {
    KnowledgeBase knowledge = services.knowledge();
    lives.listen(desk);
    lives.listen(central);
    agents.listen();
    memory.diary().begin();
    knowledge.watch(memory.diary()::note);
    main.watch(time.clock()::instant, lives);
    memory.stories().ifPresent(stories::addListener);
    main.start(
        AgentNames.KNOWLEDGE,
        new KnowledgeAgent(
            main.birth(), time, knowledge, services.describedBy(), habitLog(), spokesmen));
    main.start(AgentNames.COORDINATOR, central.now());
    main.start(AgentNames.SUPERVISOR, supervisor);
    main.start(AgentNames.DESK, desk);
    desk.whenSaid(dialogues.asked()::hear);
    desk.whenAnswered(answer -> dialogues.asked().answered(answer.part()));
    agents.begin();
    groups.beginAll();
    tracker.ifPresent(
        one -> {
          lives.listen(one);
          one.begin();
        });
    services
        .link()
        .watch(
            member -> {
              tables.memberChanged(member);
              agents.memberChanged(member);
            });
    settings
        .homeFile()
        .filter(file -> !time.clock().isStepped())
        .ifPresent(file -> new PermissionsFile(file, knowledge, time.clock(), lives).watch());
    agents.beginHosts(!past.ofCentre().recovery().equals(Recovery.NOTHING));
    if (settings.gui()) {
      main.showGui();
    }
  }

  /**
   * Starts the central agent again after it was ended; its goals go on.
   *
   * @return false when it is there
   */
  public boolean reviveCoordinator() {
    return !lives.areOver()
        && central.revive(
            revived -> {
              main.start(AgentNames.COORDINATOR, revived);
              revived.ask(deployment().agents().stream().map(AgentStart::agent).toList());
            });
  }

  /**
   * Ends an agent of the main container, as a person does in the JADE GUI.
   *
   * @throws PlatformStartException when there is none of that name
   */
  public void endAgent(String name) {
    main.end(name);
  }

  /**
   * Tells the listener of every sentence of every story from now on, on the coordinator's thread.
   */
  public void onStory(Story listener) {
    stories.addListener(listener);
  }

  /**
   * Tells the listener of the messages between agents from now on, on threads of the agents, which
   * must not be held up: of all that one of this process sends or is sent.
   *
   * @return ends it
   */
  public Runnable onMail(Consumer<SentMessage> listener) {
    return main.shared().mail().listen(listener);
  }

  /** The containers between whose agents {@link #onMail} sees no message: those of others. */
  public List<String> containersElsewhere() {
    Set<String> seen = main.shared().mail().containers();
    return directory().containers().stream()
        .map(Directory.Place::name)
        .filter(name -> !seen.contains(name))
        .toList();
  }

  /** The members that the CCA can use now. */
  public Collection<String> presentMembers() {
    return central.now().presentMembers();
  }

  public KnowledgeBase knowledge() {
    return services.knowledge();
  }

  /** Members whose agents need what no host that is there provides. */
  public Set<String> homeless() {
    return agents.homeless();
  }

  /** Where goals are stated. */
  public DeskAgent desk() {
    return desk;
  }

  /** The latest answers to questions of scripts, oldest first. */
  public List<GivenAnswer> answers() {
    return memory.answers().latest();
  }

  /** What became so and was asked for, day by day. */
  public Diary diary() {
    return memory.diary();
  }

  /** What persons of the home have said, and what was asked back. */
  public Dialogues dialogues() {
    return dialogues;
  }

  /** Simulated seconds in one of wall time. */
  public double speed() {
    return time.clock().speed();
  }

  /** Simulated time since the platform's clock began. */
  public Duration now() {
    return time.clock().now();
  }

  /** What its clock shows. */
  public Instant instant() {
    return time.clock().instant();
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
    return agents.deployer().topics();
  }

  /** What is known of containers and agents by their signs of life; of none on a stepped clock. */
  public Signs signs() {
    return agents.signs();
  }

  /** Whether the containers of the platform give signs of life; empty on a stepped clock. */
  public SortedMap<String, Condition> containers() {
    return signs().conditions();
  }

  /** Why goals cannot be taken on or pursued now, as far as this process has seen. */
  public List<String> impediments() {
    return Stream.of(busImpediment(), journalImpediment()).flatMap(Optional::stream).toList();
  }

  /** Why no device can be reached now; empty when they can. */
  public Optional<String> busImpediment() {
    return services
        .link()
        .absence()
        .map(
            reason ->
                "There is no connection to the bus (%s); what needs a device waits."
                    .formatted(reason));
  }

  /** Why nothing can be written down now that has to be first; empty when it can. */
  public Optional<String> journalImpediment() {
    return memory.impediment();
  }

  /** Whether goals outlive the process. */
  public boolean keepsJournal() {
    return settings.dataDirectory().isPresent();
  }

  /** Members that are there and cannot be used as they describe themselves, and why. */
  public SortedMap<String, String> refused() {
    SortedMap<String, String> whyByMember = new TreeMap<>();
    agents.refused().forEach((member, refusal) -> whyByMember.put(member, refusal.why()));
    return whyByMember;
  }

  /** Members that were heard of on the bus, and not cleared. */
  public Collection<RatsLink.Member> members() {
    return services.link().members();
  }

  /** Agents that stand for members or groups. */
  public List<AgentRow> agents() {
    return tables.agents(agents.deployer().containers());
  }

  /** Which agents stand for which members, how they were started, and where. */
  public Deployment deployment() {
    return agents.deployer().deployment();
  }

  /** The platform's tables: agents and containers as JADE has them. */
  public Directory directory() {
    return main.directory();
  }

  @Override
  public void close() {
    tracker.ifPresent(TrackerInService::end);
    lives.end();
    agents.closeHosts();
    // First, so that what only ends here is not taken for ended for good.
    memory.close();
    main.close(agents.close());
    services.knowledge().close();
  }
}

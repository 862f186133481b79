package org.maestro.platform;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.maestro.agents.content.Addition;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.supervision.Containers;
import org.maestro.agents.supervision.Handover;
import org.maestro.agents.supervision.Newcomer;
import org.maestro.agents.supervision.Welcome;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Charge;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.DeploymentException;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.DeviceFile;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.GroupFile;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Content;

/** The operations of the supervisor on this platform. */
final class Supervision implements Containers {
  static final String DEFAULT_TOPIC = "devices";

  private final PlatformSettings settings;
  private final Deployer deployer;
  private final PlatformTables tables;
  private final DeviceFile devices;
  private final Supplier<Home> home;
  private final GroupAgents rooms;
  private final MemberAgents agents;
  private final BooleanSupplier reviving;
  private final Registrations registrations;

  /**
   * @param home as it is now, whose words containers that join have to know
   * @param rooms the agents of rooms and other groups
   * @param reviving begins the central agent again; false when it is there
   */
  Supervision(
      PlatformSettings settings,
      MemberAgents agents,
      PlatformTables tables,
      BiFunction<String, String, Device> describedBy,
      Supplier<Home> home,
      GroupAgents rooms,
      BooleanSupplier reviving) {
    this.settings = settings;
    this.agents = agents;
    this.deployer = agents.deployer();
    this.tables = tables;
    this.devices = new DeviceFile(describedBy);
    this.home = home;
    this.rooms = rooms;
    this.reviving = reviving;
    this.registrations = new Registrations(settings.guard());
  }

  @Override
  public Handover admit(ContainerStart container, String asker) {
    String broker =
        settings
            .brokerUri()
            .orElseThrow(
                () ->
                    new DeploymentException(
                        "The bus of this platform lives within its process, where no other gets at"
                            + " it."));
    if (!agents.awaitHome()) {
      throw new DeploymentException(
          "The platform has not begun all of its own agents yet; join again in a moment.");
    }
    agents.admit(container, asker);
    return handover(broker);
  }

  private Handover handover(String broker) {
    return new Handover(broker, settings.site(), home.get().words());
  }

  @Override
  public Welcome welcome(ContainerStart container) {
    return deployer.welcome(container);
  }

  @Override
  public List<Newcomer> add(Addition addition) {
    GroupFile.Parts parts =
        new GroupFile(home.get()).read(addition.description(), addition.source());
    boolean isOfGroupsAlone = parts.devices().isBlank() && !parts.groups().isEmpty();
    List<AgentStart> starts = isOfGroupsAlone ? List.of() : starts(parts.devices(), addition);
    deployer.add(starts);
    parts.groups().forEach(rooms::begin);
    return Stream.concat(
            starts.stream().map(Supervision::newcomer),
            parts.groups().stream().map(Supervision::newcomer))
        .toList();
  }

  private static Newcomer newcomer(AgentStart start) {
    return new Newcomer(
        start.agent(),
        start.container(),
        start.members().equals(List.of(start.agent()))
            ? ""
            : ", and stands for " + String.join(", ", start.members()));
  }

  private static Newcomer newcomer(Group group) {
    return new Newcomer(
        group.id(),
        MemberAgents.container(group),
        group
            .hearing()
            .map(hearing -> ", and hears what is said in " + String.join(", ", hearing.rooms()))
            .orElse(", and stands for a group"));
  }

  private List<AgentStart> starts(String text, Addition addition) {
    List<DeviceFile.Described> described = devices.read(text, addition.source());
    List<AgentStart> starts = new ArrayList<>();
    if (addition.as().isPresent()) {
      starts.add(start(addition.as().get(), described, addition));
    } else {
      described.forEach(one -> starts.add(start(one.id(), List.of(one), addition)));
    }
    return starts;
  }

  private AgentStart start(String agent, List<DeviceFile.Described> described, Addition addition) {
    List<Charge> charges =
        described.stream().map(one -> new Charge(one.id(), Optional.of(one.text()))).toList();
    String topic =
        described.stream()
            .flatMap(one -> one.device().container().stream())
            .findFirst()
            .or(addition::container)
            .orElse(DEFAULT_TOPIC);
    String container =
        deployer.deployment().containerFor(addition.container(), topic, addition.needs());
    return new AgentStart(agent, charges, topic, addition.needs(), container);
  }

  @Override
  public void startedByHand(AgentStart start, Caller caller, Optional<StartWords.Shown> shown) {
    registrations.require(start, caller, shown);
    deployer.startedByHand(start);
  }

  @Override
  public void requireHost(Caller caller) {
    registrations.requireHost(caller);
  }

  @Override
  public AgentStart requireMovable(String agent, String container) {
    return deployer.requireMovable(agent, container);
  }

  @Override
  public void moved(String agent, String container) {
    deployer.moved(agent, container);
  }

  @Override
  public AgentStart reconfigured(String agent, String description, String source) {
    AgentStart before = deployer.deployment().require(agent);
    List<Charge> charges = new ArrayList<>(before.charges());
    for (DeviceFile.Described one : devices.read(description, source)) {
      if (!before.standsFor(one.id())) {
        throw new DeploymentException(
            "The agent %s stands for %s, not for %s; describe that, or add another agent."
                .formatted(agent, String.join(", ", before.members()), one.id()));
      }
      charges.replaceAll(
          charge ->
              charge.member().equals(one.id())
                  ? new Charge(one.id(), Optional.of(one.text()))
                  : charge);
    }
    return before.with(charges);
  }

  @Override
  public void configured(AgentStart start) {
    deployer
        .deployment()
        .find(start.agent())
        .ifPresent(now -> deployer.deployment().placed(now.with(start.charges())));
  }

  @Override
  public void remove(String agent) {
    if (!rooms.end(agent)) {
      deployer.remove(agent);
    }
  }

  @Override
  public boolean reviveCoordinator() {
    return reviving.getAsBoolean();
  }

  @Override
  public boolean isThere(String agent) {
    return tables.isThere(agent);
  }

  @Override
  public Home home() {
    return home.get();
  }

  @Override
  public Optional<Handover> offered(String host, List<String> provides) {
    Optional<Handover> bus = settings.brokerUri().map(this::handover);
    bus.ifPresent(there -> agents.offered(host, provides));
    return bus;
  }

  @Override
  public void watchOver(Pulse pulse) {
    agents.watchOver(pulse);
  }

  @Override
  public List<Content> tables(Map<String, ? extends Set<String>> services) {
    return tables.inWords(tables.agents(deployer.containers()), services);
  }
}

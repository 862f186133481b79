package org.maestro.agents.pulse;

import jade.core.AID;
import jade.core.Agent;
import jade.core.AgentContainer;
import jade.core.AgentManager;
import jade.core.BaseService;
import jade.core.ContainerID;
import jade.core.Filter;
import jade.core.GenericCommand;
import jade.core.HorizontalCommand;
import jade.core.IMTPException;
import jade.core.Node;
import jade.core.NodeDescriptor;
import jade.core.Profile;
import jade.core.ProfileException;
import jade.core.ProfileImpl;
import jade.core.Service;
import jade.core.ServiceException;
import jade.core.ServiceHelper;
import jade.core.VerticalCommand;
import jade.core.management.AgentManagementSlice;
import jade.mtp.TransportAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A JADE kernel service, which is in every container: gives its signs of life, and in the main
 * container hears those of all. JADE makes it by its class name.
 */
public final class PulseService extends BaseService {
  /** JADE finds {@link PulseProxy} by it. */
  public static final String NAME = "org.maestro.agents.pulse.Pulse";

  private static final Logger LOG = LoggerFactory.getLogger(PulseService.class);

  private final PulseSlice slice = new Local();
  private final Filter nodes = new Nodes();
  private final Filter silence = new Silence();
  private final Sessions sessions = new Sessions(new Others(), LOG::warn);
  private volatile Optional<ContainerWatch> watch = Optional.empty();

  // JADE makes a service by its class name, and says where it is before anything uses it.
  @SuppressWarnings("NullAway.Init")
  private volatile OwnPulse own;

  @SuppressWarnings("NullAway.Init")
  private volatile ProcessSession session;

  @SuppressWarnings("NullAway.Init")
  private volatile AgentContainer container;

  @Override
  public String getName() {
    return NAME;
  }

  @Override
  public void init(AgentContainer its, Profile profile) throws ProfileException {
    super.init(its, profile);
    container = its;
    ProcessPulse pulse =
        profile instanceof ProfileImpl all
                && all.getProperties().get(ProcessPulse.KEY) instanceof ProcessPulse shared
            ? shared
            : new ProcessPulse();
    session = pulse.session();
    own = new OwnPulse(pulse, new Road());
  }

  @Override
  public Class<?> getHorizontalInterface() {
    return PulseSlice.class;
  }

  @Override
  public Service.Slice getLocalSlice() {
    return slice;
  }

  @Override
  public Filter getCommandFilter(boolean direction) {
    return direction == Filter.INCOMING ? nodes : silence;
  }

  @Override
  public ServiceHelper getHelper(Agent agent) {
    return new Helper();
  }

  @Override
  public void shutdown() {
    own.end();
    watch.ifPresent(ContainerWatch::end);
    watch = Optional.empty();
    super.shutdown();
  }

  /**
   * A container that has been given up tells nobody of its agents' ends: others have their names
   * now, and JADE would take those out.
   */
  private final class Silence extends Filter {
    @Override
    public boolean accept(VerticalCommand command) {
      return !command.getName().equals(AgentManagementSlice.INFORM_KILLED) || !own.isGivenUp();
    }
  }

  /** From this container to the main one. */
  private final class Road implements OwnPulse.Road {
    @Override
    public String beat(String beat) throws IMTPException, ServiceException {
      PulseSlice main = (PulseSlice) getSlice(MAIN_SLICE);
      if (main == null) {
        throw new ServiceException("There is no main container");
      }
      try {
        if (session.name().isEmpty()) {
          main.begin(container(), session.await());
        }
        return session.confirmed(main.beat(session.seal(beat)));
      } catch (IMTPException | IllegalArgumentException e) {
        session.end();
        throw e;
      }
    }

    @Override
    public String container() {
      return container.getID().getName();
    }

    @Override
    public List<String> addresses() {
      return localAddresses();
    }

    @Override
    public boolean isMain() {
      return container.getMain() instanceof AgentManager;
    }
  }

  private List<String> localAddresses() {
    List<String> addresses = new ArrayList<>();
    try {
      for (Object address : getIMTPManager().getLocalAddresses().toArray()) {
        TransportAddress one = (TransportAddress) address;
        addresses.add(one.getHost() + ":" + one.getPort());
      }
    } catch (IMTPException e) {
      LOG.debug("JADE does not tell where it listens", e);
    }
    return addresses;
  }

  private String heard(String text) {
    Sealed sealed = sessions.heard(text);
    Beat beat = Beat.read(sealed.text());
    Confirmation confirmation =
        watch
            .map(watching -> heard(watching, sealed, beat))
            .orElseGet(() -> Confirmation.of(HeartbeatSettings.standard(), List.of()));
    return sessions.confirm(sealed, confirmation.write());
  }

  private Confirmation heard(ContainerWatch watching, Sealed sealed, Beat beat) {
    Set<String> joined = joined();
    Map<Boolean, List<Beat.Living>> byJoined =
        beat.containers().stream()
            .collect(Collectors.partitioningBy(living -> joined.contains(living.name())));
    // Who is none of the platform's is only told so.
    List<Beat.Living> heard =
        Stream.concat(
                sessions.own(sealed, byJoined.getOrDefault(true, List.of())).stream(),
                byJoined.getOrDefault(false, List.of()).stream())
            .toList();
    return watching.heard(new Beat(heard, beat.silences()), joined);
  }

  /** A platform that has taken over does not know the containers of the one before it. */
  private Set<String> joined() {
    return Stream.of(container.getMain().containerIDs())
        .map(ContainerID::getName)
        .collect(Collectors.toSet());
  }

  /**
   * The agent's own thread may come to life again at any time; what it does then is nothing, and
   * JADE is not told of its end a second time.
   */
  private void takeOut(String agent) {
    AID id = new AID(agent + "@" + container.getPlatformID(), AID.ISGUID);
    Agent hung = container.acquireLocalAgent(id);
    if (hung == null) {
      return;
    }
    container.releaseLocalAgent(id);
    own.forsake(agent);
    hung.doDelete();
    GenericCommand killed =
        new GenericCommand(AgentManagementSlice.INFORM_KILLED, AgentManagementSlice.NAME, null);
    killed.addParam(id);
    try {
      // Only the service whose command it is may give it.
      container.getServiceFinder().findService(AgentManagementSlice.NAME).submit(killed);
    } catch (IMTPException | ServiceException e) {
      throw new IllegalStateException("The agent " + agent + " cannot be taken out", e);
    }
  }

  private final class Helper implements Pulse {
    @Override
    public void init(Agent agent) {
      // Who enlists says its name.
    }

    @Override
    public void enlist(String name, Consumer<Runnable> tell, Runnable forsake, Clock clock) {
      own.enlist(name, tell, forsake, clock);
    }

    @Override
    public void end(String name, String agent) {
      try {
        PulseSlice there = (PulseSlice) getSlice(name);
        if (there == null) {
          throw new IllegalStateException("There is no container " + name + " any more");
        }
        there.end(sessions.order(name, agent));
      } catch (ServiceException | IMTPException e) {
        throw new IllegalStateException("The container " + name + " cannot be asked", e);
      }
    }

    @Override
    public void leave(String name) {
      own.leave(name);
    }

    @Override
    public boolean isCutOff() {
      return own.isCutOff();
    }

    @Override
    public void whenGivenUp(Runnable listener) {
      own.whenGivenUp(listener);
    }

    @Override
    public void watch(Clock clock, HeartbeatSettings settings, Watcher watcher) {
      ContainerWatch watching =
          new ContainerWatch(clock, settings, container.getID().getName(), watcher);
      watch = Optional.of(watching);
      watching.begin();
    }

    @Override
    public List<String> addresses(String name) {
      List<String> own = localAddresses();
      return watch.map(watching -> watching.addresses(name)).orElse(List.of()).stream()
          .filter(address -> !own.contains(address))
          .toList();
    }

    @Override
    public Signs signs() {
      return watch.map(ContainerWatch::signs).orElseGet(Signs::none);
    }
  }

  /** The containers of the platform, by their parts of this service. */
  private final class Others implements Sessions.Containers {
    @Override
    public void tell(String name, String request, String key) {
      try {
        slice(name).key(request, key);
      } catch (ServiceException | IMTPException e) {
        throw new IllegalArgumentException("The container " + name + " takes no key", e);
      }
    }

    @Override
    public String session(String name) {
      try {
        return slice(name).session();
      } catch (ServiceException | IMTPException e) {
        LOG.debug("The container {} cannot be asked for its session", name, e);
        return "";
      }
    }

    private PulseSlice slice(String name) throws ServiceException {
      PulseSlice there = (PulseSlice) getSlice(name);
      if (there == null) {
        throw new ServiceException("There is no container " + name);
      }
      return there;
    }
  }

  /** JADE tells of each container that ends, also with its process. */
  private final class Nodes extends Filter {
    @Override
    protected boolean accept(VerticalCommand command) {
      if (command.getName().equals(DEAD_NODE)
          && command.getParam(0) instanceof NodeDescriptor node
          && node.getContainer() != null) {
        watch.ifPresent(watching -> watching.ended(node.getContainer().getName()));
      }
      return true;
    }
  }

  private final class Local implements PulseSlice {
    private static final long serialVersionUID = 1L;

    @Override
    public Service getService() {
      return PulseService.this;
    }

    @Override
    public Node getNode() throws ServiceException {
      try {
        return getLocalNode();
      } catch (IMTPException e) {
        throw new ServiceException("The container has no node", e);
      }
    }

    @Override
    public @Nullable VerticalCommand serve(HorizontalCommand command) {
      try {
        command.setReturnValue(answer(command));
      } catch (IllegalStateException | IllegalArgumentException e) {
        LOG.debug("What the heartbeats of another container ask is refused", e);
        command.setReturnValue(e);
      }
      return null;
    }

    private @Nullable Object answer(HorizontalCommand command) {
      switch (command.getName()) {
        case BEAT:
          return beat((String) command.getParam(0));
        case SESSION:
          return session();
        case END:
          end((String) command.getParam(0));
          return null;
        case BEGIN:
          begin((String) command.getParam(0), (String) command.getParam(1));
          return null;
        case KEY:
          key((String) command.getParam(0), (String) command.getParam(1));
          return null;
        default:
          return null;
      }
    }

    @Override
    public String beat(String beat) {
      return heard(beat);
    }

    @Override
    public void end(String order) {
      try {
        takeOut(session.ordered(order));
      } catch (IllegalArgumentException e) {
        LOG.warn(
            "Somebody wanted to have an agent taken out of {}: {}",
            container.getID().getName(),
            e.getMessage());
        throw e;
      }
    }

    @Override
    public void begin(String its, String request) {
      sessions.begin(its, request);
    }

    @Override
    public void key(String request, String key) {
      session.begin(request, key);
    }

    @Override
    public String session() {
      return session.name().orElse("");
    }
  }
}

package org.maestro.agents.device;

import jade.core.Agent;
import jade.core.AgentContainer;
import jade.core.BaseService;
import jade.core.Profile;
import jade.core.ProfileException;
import jade.core.ProfileImpl;
import jade.core.ServiceHelper;
import org.maestro.agents.runtime.AgentTable;

/**
 * A JADE kernel service by which agents that JADE itself makes or brings (by class name, from its
 * GUI, or out of another container) get at what their container gives them. JADE makes it by its
 * class name in every container of MAESTRO.
 */
public final class HostService extends BaseService {
  public static final String NAME = "org.maestro.Host";

  /** Where a container's profile holds its {@link Host}. */
  public static final String KEY = "maestro-host";

  private Host host = new Host();

  /** The service helper by which an agent reaches its container's host. */
  public interface Access extends ServiceHelper {
    Host host();
  }

  @Override
  public String getName() {
    return NAME;
  }

  @Override
  public void init(AgentContainer container, Profile profile) throws ProfileException {
    super.init(container, profile);
    if (profile instanceof ProfileImpl all && all.getProperties().get(KEY) instanceof Host given) {
      host = given;
    }
    AgentTable.guard(container);
    host.attach(container);
  }

  @Override
  public void shutdown() {
    super.shutdown();
    host.end();
  }

  @Override
  public ServiceHelper getHelper(Agent agent) {
    return new Access() {
      @Override
      public void init(Agent owner) {
        // All agents of a container are given the same.
      }

      @Override
      public Host host() {
        return host;
      }
    };
  }
}

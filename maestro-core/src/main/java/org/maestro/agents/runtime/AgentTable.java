package org.maestro.agents.runtime;

import jade.core.AgentContainer;
import jade.util.leap.Collection;
import jade.util.leap.HashMap;
import jade.util.leap.Map;
import jade.util.leap.Set;
import java.lang.reflect.Field;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The table of a container's agents, to be read and changed by any thread. JADE 4.3 reads its own
 * under a lock and changes it without: when two agents end at the same moment the table may count
 * one that is not there, and from then on JADE can neither end the container nor list its agents.
 */
public final class AgentTable extends HashMap {
  private static final long serialVersionUID = 1;
  private static final Logger LOG = LoggerFactory.getLogger(AgentTable.class);

  /** Takes the place of JADE's own table, before there are agents. */
  public static void guard(AgentContainer container) {
    try {
      Field table = container.getClass().getDeclaredField("localAgents");
      table.setAccessible(true);
      Object agents = table.get(container);
      Field rows = agents.getClass().getDeclaredField("agents");
      rows.setAccessible(true);
      AgentTable guarded = new AgentTable();
      Map before = (Map) rows.get(agents);
      for (Object name : before.keySet().toArray()) {
        guarded.put(name, before.get(name));
      }
      rows.set(agents, guarded);
    } catch (ReflectiveOperationException | RuntimeException e) {
      LOG.warn("Another JADE than 4.3? Its table of agents is not guarded here", e);
    }
  }

  // JADE locks the table itself to read it.

  @Override
  public synchronized Object put(Object name, Object row) {
    return super.put(name, row);
  }

  @Override
  public synchronized Object remove(Object name) {
    return super.remove(name);
  }

  @Override
  public synchronized Object get(Object name) {
    return super.get(name);
  }

  @Override
  public synchronized boolean containsKey(Object name) {
    return super.containsKey(name);
  }

  @Override
  public synchronized int size() {
    return super.size();
  }

  @Override
  public synchronized Set keySet() {
    return super.keySet();
  }

  @Override
  public synchronized Collection values() {
    return super.values();
  }
}

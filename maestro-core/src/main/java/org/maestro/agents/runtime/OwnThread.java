package org.maestro.agents.runtime;

/** An agent's own thread, as the parts of the agent use it. */
public interface OwnThread {
  /** Has it do this, soon. Any thread may call. */
  void tell(Runnable action);

  /** Does this now; what goes wrong in it goes to the log. The agent's own thread only. */
  void work(Runnable action);

  /** Has the agent look for work. Any thread may call. */
  void wake();
}

package org.maestro.rats.member;

import java.util.Map;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.RatsError;

/**
 * One running call as its procedure sees it. The first final report counts, later ones do nothing.
 * Clock thread only.
 */
public interface Execution {

  Call call();

  /** A continuous feature runs and these are its first values. */
  void established(Map<String, Object> values);

  /** A value set of a continuous feature's stream. */
  void observed(Map<String, Object> values);

  void progress(double fraction);

  void succeed(Map<String, Object> values);

  void fail(RatsError error);

  /**
   * What to do on cancel or timeout: bring the device to a safe state (M45), then run the given
   * completion. Without it a cancel completes at once.
   */
  void onCancel(ExitStrategy strategy);

  boolean ended();

  interface ExitStrategy {
    void exit(Runnable safe);
  }
}

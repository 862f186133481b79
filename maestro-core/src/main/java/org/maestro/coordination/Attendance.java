package org.maestro.coordination;

import java.util.Optional;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.recovery.RecoveryBarrier;

/**
 * The coming and going of members, as the goals hear of it: the roster is changed and the journal
 * written before any goal plans anew. The coordinator's thread only.
 *
 * <p>Source: Three-layered architecture, 3.3.3 (M20, M21).
 */
final class Attendance {
  private final Ports ports;
  private final Roster roster;
  private final RecoveryBarrier comeback;
  private final ExactPrices exactPrices;
  private final ActiveGoals activeGoals;

  Attendance(
      Ports ports,
      Roster roster,
      RecoveryBarrier comeback,
      ExactPrices exactPrices,
      ActiveGoals activeGoals) {
    this.ports = ports;
    this.roster = roster;
    this.comeback = comeback;
    this.exactPrices = exactPrices;
    this.activeGoals = activeGoals;
  }

  void present(String member, Optional<String> life) {
    activeGoals.experience().forget(member);
    roster.present(member, life);
    ports.journal().write(new JournalEntry.MemberCame(member, life));
    comeback.present(member);
    activeGoals.run(
        () -> {
          activeGoals.otherManagers().forget(member);
          activeGoals.all().forEach(pursuit -> pursuit.memberPresent(member));
          doubtOver(member);
        });
  }

  void doubted(String member, String reason) {
    if (roster.doubt(member, reason)) {
      comeback.doubt(member);
    }
  }

  void away(String member, String reason) {
    if (!roster.isThere(member)) {
      roster.absent(member, reason);
    }
  }

  void trusted(String member) {
    if (roster.trust(member)) {
      comeback.present(member);
      activeGoals.run(
          () -> {
            activeGoals.otherManagers().forget(member);
            doubtOver(member);
          });
    }
  }

  void lost(String member, String reason) {
    if (!roster.isThere(member)) {
      away(member, reason);
      return;
    }
    roster.absent(member, reason, ports.clock().now());
    ports.journal().write(new JournalEntry.MemberWent(member, reason));
    exactPrices.forget(member);
    ports.knowledge().lost(member);
    activeGoals.run(
        () -> {
          activeGoals.leases().lost(member);
          activeGoals.otherManagers().forget(member);
          activeGoals.all().forEach(pursuit -> pursuit.memberLost(member));
          doubtOver(member);
        });
  }

  private void doubtOver(String member) {
    activeGoals.all().forEach(pursuit -> pursuit.doubtOver(member));
  }
}

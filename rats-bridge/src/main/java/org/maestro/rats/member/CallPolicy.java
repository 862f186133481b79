package org.maestro.rats.member;

/**
 * The access rules of a site: who may call which feature of whom. The broker makes sure that a
 * caller is who it says; the member asks here before it does anything for it.
 */
public interface CallPolicy {

  /** Of a site without security: anybody may call anything, also on the paper's bare topics. */
  CallPolicy OPEN =
      new CallPolicy() {
        @Override
        public boolean allows(String caller, String member, String feature) {
          return true;
        }

        @Override
        public boolean isSecured() {
          return false;
        }
      };

  /**
   * @param feature also a reserved one; who may not {@code $cancel} may still end its own calls
   */
  boolean allows(String caller, String member, String feature);

  /** Whether callers must be named by the topic, which the broker vouches for. */
  boolean isSecured();
}

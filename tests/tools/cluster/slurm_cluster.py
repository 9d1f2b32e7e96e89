"""A Slurm of its own on this machine: munged, slurmctld and several slurmds, with ports, keys and folders of their own.

Needs Debian's slurm-wlm and munge. Nothing of a Slurm that the machine may have otherwise is touched.
"""

import getpass
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sacct")

# A requeued task waits until its last credential has expired (cred_expire), by default for two minutes.
CONFIGURATION = """\
ClusterName=campuswalk
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,bf_interval=1,sched_interval=1,requeue_setup_env_fail
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=20
BatchStartTimeout=2
KillWait=5
MaxArraySize=20001
MaxJobCount=30000
MinJobAge=300
NodeName=n[1-{nodes}] NodeHostname={host} NodeAddr=127.0.0.1 Port={ports} CPUs={cpus}
PartitionName=main Nodes=ALL Default=YES MaxTime=60 State=UP
"""


def missing_programs():
    """Those of PROGRAMS that aren't installed; daemons may be where only root's PATH leads."""
    path = os.environ["PATH"] + ":/usr/sbin:/sbin"
    return [name for name in PROGRAMS if shutil.which(name, path=path) is None]


def _free_ports(count):
    """Consecutive ones, as slurm.conf wants them."""
    for first in range(26800 + os.getpid() % 1000, 32000, count):
        sockets = []
        try:
            for port in range(first, first + count):
                each = socket.socket()
                sockets.append(each)
                each.bind(("127.0.0.1", port))
            return first
        except OSError:
            continue
        finally:
            for each in sockets:
                each.close()
    raise RuntimeError("no free ports")


class SlurmCluster:
    """With `nodes` nodes of `cpus` processors each, whatever the machine has."""

    def __init__(self, nodes=2, cpus=2):
        self.nodes = ["n%d" % i for i in range(1, nodes + 1)]
        self.folder = tempfile.mkdtemp(prefix="campuswalk-slurm-")
        os.chmod(self.folder, 0o755)  # munged wants its socket's folder to be accessible
        self.processes = {}
        first = _free_ports(nodes + 1)
        os.mkdir(self.path("state"))
        for node in self.nodes:
            os.mkdir(self.path("spool." + node))
        with open(self.path("munge.key"), "wb") as key:
            os.chmod(self.path("munge.key"), 0o600)
            key.write(os.urandom(1024))
        with open(self.path("slurm.conf"), "w", encoding="utf-8") as file:
            file.write(CONFIGURATION.format(folder=self.folder, host=socket.gethostname().split(".")[0],
                                            user=getpass.getuser(), controller=first, nodes=nodes, cpus=cpus,
                                            ports="%d-%d" % (first + 1, first + nodes)))

    @property
    def environment(self):
        """In which Slurm's programs know this cluster."""
        return dict(os.environ, SLURM_CONF=self.path("slurm.conf"), PATH=os.environ["PATH"] + ":/usr/sbin:/sbin")

    def path(self, name):
        return os.path.join(self.folder, name)

    def __enter__(self):
        try:
            self._start("munged", "munged", "--foreground", "--force", "--key-file=" + self.path("munge.key"),
                        "--socket=" + self.path("munge.socket"), "--pid-file=" + self.path("munged.pid"),
                        "--log-file=" + self.path("munged.log"), "--seed-file=" + self.path("munged.seed"))
            self._wait_until(lambda: os.path.exists(self.path("munge.socket")), "munged")
            self._start("slurmctld", "slurmctld", "-D", "-c")
            for node in self.nodes:
                self.start_node(node)
            self._wait_until(self._is_up, "the cluster")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        """Ends what it has started, the tasks that are left first."""
        for process in self.task_processes():
            self._kill(process)
        for name in ("slurmctld", *self.nodes, "munged"):
            if name in self.processes:
                self.processes[name].terminate()
        for process in self.processes.values():
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        if os.environ.get("KEEP_SLURM"):  # for a look at its logs
            print("kept:", self.folder)
        else:
            shutil.rmtree(self.folder, ignore_errors=True)

    def _start(self, name, *command):
        with open(self.path(name + ".out"), "ab") as out:
            self.processes[name] = subprocess.Popen(command, env=self.environment, stdin=subprocess.DEVNULL, stdout=out,
                                                    stderr=out, start_new_session=True)

    def _wait_until(self, condition, what, seconds=30):
        until = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > until:
                raise RuntimeError("%s didn't start; KEEP_SLURM=1 keeps the logs" % what)
            time.sleep(0.1)

    def _is_up(self):
        states = self.ask("sinfo", "--Node", "--noheader", "--format=%T").split()
        return len(states) == len(self.nodes) and all(state.startswith(("idle", "mixed")) for state in states)

    def ask(self, *command):
        done = subprocess.run(command, env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=60, check=False)
        return done.stdout

    def queue(self):
        """The tasks and jobs that wait or run: {"12_3": ("RUNNING", "n1")}."""
        lines = self.ask("squeue", "--array", "--noheader", "--format=%i %T %N").splitlines()
        return {fields[0]: (fields[1], fields[2] if len(fields) > 2 else "") for fields in map(str.split, lines)}

    def start_node(self, node):
        self._start(node, "slurmd", "-D", "-N", node)

    def task_processes(self, **variables):
        """Processes of tasks (their environment has these variables), without Slurm's own."""
        wanted = [b"SLURM_CONF=" + self.path("slurm.conf").encode(), b"SLURM_JOB_ID="]
        wanted += [("%s=%s" % each).encode() for each in variables.items()]
        found = []
        for entry in os.listdir("/proc"):
            if not entry.isdigit():
                continue
            try:
                with open("/proc/%s/environ" % entry, "rb") as file:
                    environment = file.read().split(b"\0")
            except OSError:
                continue
            if all(any(line == each or (each.endswith(b"ID=") and line.startswith(each)) for line in environment)
                   for each in wanted):
                found.append(int(entry))
        return found

    def step_daemons(self, node):
        """slurmstepds of a node: children of its slurmd, or of init once that is gone."""
        found = []
        for entry in os.listdir("/proc"):
            if not entry.isdigit():
                continue
            try:
                with open("/proc/%s/environ" % entry, "rb") as file:
                    environment = file.read()
                with open("/proc/%s/comm" % entry, encoding="utf-8") as file:
                    name = file.read().strip()
            except OSError:
                continue
            if name == "slurmstepd" and self.folder.encode() in environment and self._is_of_node(entry, node):
                found.append(int(entry))
        return found

    def _is_of_node(self, step, node):
        """By the spool folder that it has open or works in."""
        spool = self.path("spool." + node)
        links = [os.path.join("/proc", step, "cwd")]
        descriptors = os.path.join("/proc", step, "fd")
        try:
            links += [os.path.join(descriptors, name) for name in os.listdir(descriptors)]
            return any(os.readlink(link).startswith((spool, self.path("slurmd.%s.log" % node))) for link in links)
        except OSError:
            return False

    @staticmethod
    def _kill(process):
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass

    def kill_node(self, node):
        """As if its power failed: everything of it is gone at once, and nothing says good-bye."""
        self.processes[node].kill()
        self.processes[node].wait()
        for process in self.step_daemons(node) + self.task_processes(SLURMD_NODENAME=node):
            self._kill(process)

//! Opens a graphics adapter, without a window.

use crate::RenderError;

/// An open adapter.
pub(super) struct Device {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    /// Its name, for people.
    pub(super) description: String,
    /// Whether it is a driver that computes on the CPU.
    pub(super) is_software: bool,
}

/// Whether this machine can have a graphics adapter at all.
///
/// On Linux every driver of real hardware shows a device node. Where there is none, asking Vulkan
/// finds a driver that computes on the CPU at best, takes longer, and Mesa's layers write
/// complaints about a missing display to the terminal.
pub(crate) fn may_exist() -> bool {
    const NODES: [&str; 4] = ["/dev/dri", "/dev/nvidia0", "/dev/dxg", "/dev/kgsl-3d0"];
    !cfg!(target_os = "linux") || NODES.iter().any(|node| std::path::Path::new(node).exists())
}

impl Device {
    /// Opens the adapter that the system prefers; `WGPU_BACKEND` and `WGPU_ADAPTER_NAME` choose.
    ///
    /// # Errors
    /// [`RenderError::NoAdapter`] where there is none or it cannot be opened.
    pub(super) fn open() -> Result<Self, RenderError> {
        let instance =
            wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..wgpu::RequestAdapterOptions::default()
        };
        let adapter =
            pollster::block_on(instance.request_adapter(&options)).map_err(|e| refused(&e))?;
        let limits = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("lole"),
            required_limits: limits,
            ..wgpu::DeviceDescriptor::default()
        }))
        .map_err(|e| refused(&e))?;
        let found = adapter.get_info();
        Ok(Self {
            device,
            queue,
            description: format!("{} ({})", found.name, found.backend),
            is_software: found.device_type == wgpu::DeviceType::Cpu,
        })
    }
}

fn refused(error: &dyn std::error::Error) -> RenderError {
    RenderError::NoAdapter {
        reason: error.to_string(),
    }
}
